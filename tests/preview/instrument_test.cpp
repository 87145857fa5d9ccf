// The instrument in the preview's window: what is clicked and drawn is measured as `fringe profile` does.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "preview/session.hpp"

namespace fringe::preview {
namespace {

using cli::Arguments;

constexpr int kInstrument = 470;  // pixels, of the window's right

// The wall behind Young's slits, four centimetres of it. With one sample that is in the middle: others lie
// where the pixel's number says, and a point is another pixel than the middle of a line.
const Arguments kYoung = {FRINGE_SOURCE_DIR "/scenes/laboratory/young.json",
                          "--set",
                          "camera.height=0.04",
                          "--set",
                          "image.height=160",
                          "--set",
                          "image.width=160",
                          "--set",
                          "image.samples=1"};
constexpr double kShown = 0.04;  // metres that the picture's height shows

struct Csv {
    std::vector<std::string> names;
    std::vector<std::vector<double>> rows;

    double at(std::size_t row, const std::string& name) const {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == name) return rows.at(row).at(i);
        ADD_FAILURE() << "no column " << name;
        return 0.0;
    }
};

Csv read(const std::filesystem::path& file) {
    Csv csv;
    std::ifstream stream(file);
    for (std::string row; std::getline(stream, row);) {
        if (row.starts_with('#')) continue;
        std::istringstream cells(row);
        std::vector<double> numbers;
        for (std::string cell; std::getline(cells, cell, ',');) {
            if (row.starts_with("position")) csv.names.push_back(cell);
            else numbers.push_back(std::stod(cell));
        }
        if (!numbers.empty()) csv.rows.push_back(numbers);
    }
    return csv;
}

// Presses X until a file is there that says what `column` is. The closed form comes after the measurement.
Csv written(const Session& session, const std::string& name, const std::string& column = "closed_form_W_m2") {
    Csv csv;
    EXPECT_TRUE(becomes([&] {
        session.key("x");
        const std::filesystem::path file = session.folder() / name;
        if (!std::filesystem::exists(file)) return false;
        csv = read(file);
        return !csv.names.empty() && csv.names.back() == column;
    })) << name;
    return csv;
}

// What `fringe profile` has between the ends of a line that has these samples.
Csv profiled(const Session& session, const Csv& like, std::size_t samples, double step) {
    const auto point = [&](std::size_t row, double shift) {
        return fmt::format("{:.9g},{:.9g},{:.9g}", like.at(row, "x_m") + shift, like.at(row, "y_m"),
                           like.at(row, "z_m"));
    };
    const std::string file = (session.folder() / "expected.csv").string();
    const double half = like.rows.size() == 1 ? 0.5 * static_cast<double>(samples) * step : 0.5 * step;
    Arguments arguments{"profile",
                        "--closed-form",
                        "--quiet",
                        "-o",
                        file,
                        "--samples",
                        std::to_string(samples),
                        "--from",
                        point(0, -half),
                        "--to",
                        point(like.rows.size() - 1, half)};
    arguments.insert(arguments.begin() + 1, kYoung.begin(), kYoung.end());
    expectDone(cli::run(arguments));
    return read(file);
}

Arguments preview() {
    Arguments arguments{"preview", "--samples", "2"};
    arguments.insert(arguments.end(), kYoung.begin(), kYoung.end());
    return arguments;
}

// The picture fills what the panels leave of the window: square, in the middle.
struct Place {
    double left, top, side;
};

Place placeIn(const Screen& window) {
    const double width = 1.0 * window.width - kPanel - kInstrument, height = window.height;
    const double side = std::min(width, height);
    return {kPanel + 0.5 * (width - side), 0.5 * (height - side), side};
}

// The pipeline has its values in uniforms and rounds otherwise than the one that they are compiled into.
constexpr double kSingleRounding = 1e-4;

TEST(InstrumentOnDevice, APointIsMeasuredAsAProfileOfItWouldBe) {
    Session session(preview());
    ASSERT_TRUE(session.completes());
    const std::uint32_t before = session.picture().width;
    session.key("i");
    Screen window;
    ASSERT_TRUE(becomes([&] {
        window = session.picture();
        return window.width > before;
    }));
    const Place place = placeIn(window);
    const int x = static_cast<int>(place.left + 0.62 * place.side);
    const int y = static_cast<int>(place.top + 0.4 * place.side);
    session.click(x, y);
    const Csv point = written(session, "young-point.csv");
    ASSERT_EQ(point.rows.size(), 1U);
    const double perPixel = kShown / place.side;
    EXPECT_NEAR(point.at(0, "x_m"), (x - place.left - 0.5 * place.side) * perPixel, 1.5 * perPixel);
    EXPECT_NEAR(point.at(0, "y_m"), -(y - place.top - 0.5 * place.side) * perPixel, 1.5 * perPixel);
    EXPECT_NEAR(point.at(0, "z_m"), -2.0, 1e-9);

    const Csv expected = profiled(session, point, 3, 2 * point.at(0, "position_m"));
    for (std::size_t i = 1; i < point.names.size(); ++i) {
        const std::string& name = point.names[i];
        EXPECT_NEAR(point.at(0, name), expected.at(1, name), kSingleRounding * std::abs(expected.at(1, name)))
            << name;
    }
    EXPECT_GT(point.at(0, "irradiance_W_m2"), 0.0);
    for (const char* name : {"young-point.png", "young-point.svg"})
        EXPECT_TRUE(std::filesystem::exists(session.folder() / name)) << name;
    expectDone(session.quit());
}

TEST(InstrumentOnDevice, ALineIsMeasuredAsByProfile) {
    Session session(preview());
    ASSERT_TRUE(session.completes());
    const std::uint32_t before = session.picture().width;
    session.key("i");
    Screen window;
    ASSERT_TRUE(becomes([&] {
        window = session.picture();
        return window.width > before;
    }));
    const Place place = placeIn(window);
    const auto at = [&](double share, double start) { return static_cast<int>(start + share * place.side); };
    session.drag(at(0.1, place.left), at(0.5, place.top), at(0.9, place.left), at(0.5, place.top));
    const Csv line = written(session, "young-profile.csv");
    ASSERT_EQ(line.rows.size(), 1000U);
    const double perPixel = kShown / place.side;
    EXPECT_NEAR(line.at(999, "x_m") - line.at(0, "x_m"), 0.8 * kShown, 3.0 * perPixel);

    const double step = line.at(1, "position_m") - line.at(0, "position_m");
    const Csv expected = profiled(session, line, 1000, step);
    double peak = 0.0;
    for (std::size_t i = 0; i < 1000; ++i) peak = std::max(peak, expected.at(i, "irradiance_W_m2"));
    EXPECT_GT(peak, 0.0);
    for (std::size_t i = 0; i < 1000; ++i) {
        for (const char* name : {"irradiance_W_m2", "closed_form_W_m2"})
            ASSERT_NEAR(line.at(i, name), expected.at(i, name), kSingleRounding * peak) << name << i;
    }
    expectDone(session.quit());
}

}  // namespace
}  // namespace fringe::preview
