// fringe profile: the experiments of scenes/laboratory with their known wavelengths, irradiance against
// closed forms, and what is said about lines that cannot be measured.
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "cli/support.hpp"

namespace fringe::cli {
namespace {

std::string laboratory(const std::string& name) {
    return FRINGE_SOURCE_DIR "/scenes/laboratory/" + name;
}

Arguments line(const std::string& from, const std::string& to) {
    return {"--from", from, "--to", to};
}

Json::Value profileOf(const Arguments& arguments) {
    const Outcome outcome = run(Arguments{"profile"} + arguments + Arguments{"--json"});
    expectDone(outcome);
    return parsedJson(outcome.out);
}

Arguments sodium() {
    return Arguments{laboratory("sodium.json")} + line("0.3065,0,-1", "0.3105,0,-1");
}

void expectWavelengths(const Json::Value& profile, const std::vector<double>& wavelengths_nm,
                       double tolerance_nm) {
    ASSERT_EQ(profile["maxima"].size(), wavelengths_nm.size()) << profile["maxima"];
    for (Json::ArrayIndex i = 0; i < profile["maxima"].size(); ++i) {
        const Json::Value& maximum = profile["maxima"][i];
        const double error = std::abs(maximum["wavelength_nm"].asDouble() - wavelengths_nm[i]);
        EXPECT_LE(error, tolerance_nm) << maximum;
        EXPECT_LE(error, 3.0 * maximum["uncertainty_nm"].asDouble()) << maximum;
        EXPECT_FALSE(maximum.isMember("unresolved_nm")) << maximum;
    }
}

// ---- the experiments ----------------------------------------------------------------------------

// NIST: 588.995 and 589.592 nm; 0.05 nm is what the experiment promises.
TEST(LaboratoryOnDevice, SodiumIsADoublet) {
    const Json::Value profile = profileOf(sodium());
    expectWavelengths(profile, {588.995, 589.592}, 0.05);
    EXPECT_EQ(profile["maxima"][0]["order"], 1);
    EXPECT_LE(profile["maxima"][0]["uncertainty_nm"].asDouble(), 0.05);
    // The stronger line has twice the power. The foot of each lies under the other.
    EXPECT_NEAR(profile["maxima"][0]["irradiance_W_m2"].asDouble() /
                    profile["maxima"][1]["irradiance_W_m2"].asDouble(),
                2.0, 0.1);
}

TEST(LaboratoryOnDevice, SodiumIsUnresolvedWithTooFewSlits) {
    const Json::Value profile = profileOf(sodium() + Arguments{"--set", "lights.grating.aperture.count=700"});
    ASSERT_EQ(profile["maxima"].size(), 1U);
    const Json::Value& maximum = profile["maxima"][0];
    ASSERT_EQ(maximum["unresolved_nm"].size(), 2U);
    EXPECT_NEAR(maximum["unresolved_nm"][0].asDouble(), 588.995, 1e-3);
    EXPECT_NEAR(maximum["unresolved_nm"][1].asDouble(), 589.592, 1e-3);
    EXPECT_NEAR(maximum["slits_needed"].asDouble(), 987.0, 1.0);  // 589.2 / 0.597
    EXPECT_FALSE(maximum.isMember("focus_needed_m"));
    const Outcome text = run(Arguments{"profile"} + sodium() +
                             Arguments{"--set", "lights.grating.aperture.count=700", "--quiet"});
    EXPECT_EQ(text.out, "");
}

TEST(LaboratoryOnDevice, SodiumIsUnresolvedUnderTheBeamsFootprint) {
    const Outcome outcome =
        run(Arguments{"profile", laboratory("sodium-unfocused.json")} + line("0.298,0,-1", "0.319,0,-1"));
    expectDone(outcome);
    EXPECT_TRUE(contains(outcome.out, "unresolved: maximum 1 holds 589.00, 589.59 nm")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "a beam.focus of 1.146 m would bring it together")) << outcome.out;
}

// Fringes are wavelength distance/separation apart; the pattern of one slit draws them towards the middle by
// (2 pi^2/3) (20/200)^2/(2 pi^2) = 1/300 of it.
TEST(LaboratoryOnDevice, YoungsFringesAreWavelengthTimesDistanceOverSeparationApart) {
    const Json::Value profile =
        profileOf(Arguments{laboratory("young.json")} + line("-0.04,0,-2", "0.04,0,-2"));
    const Json::Value& maxima = profile["maxima"];
    ASSERT_EQ(maxima.size(), 13U);
    const double spacing = (maxima[12]["position_m"].asDouble() - maxima[0]["position_m"].asDouble()) / 12.0;
    const double expected = 632.8e-9 * 2.0 / 200e-6;
    EXPECT_NEAR(spacing, expected * (1.0 - 1.0 / 300.0), 1e-3 * expected);
    EXPECT_NEAR(maxima[6]["position_m"].asDouble(), 0.04, 2e-6);
    for (Json::ArrayIndex i = 0; i < 13; ++i) {
        if (i == 6) continue;
        EXPECT_EQ(maxima[i]["order"], static_cast<int>(i) - 6);
        EXPECT_LE(std::abs(maxima[i]["wavelength_nm"].asDouble() - 632.8),
                  maxima[i]["uncertainty_nm"].asDouble());
    }
}

TEST(LaboratoryOnDevice, HydrogenHasTheBalmerLines) {
    const Json::Value profile = profileOf(Arguments{laboratory("hydrogen.json"), "--samples", "4000"} +
                                          line("0.18,0,-1", "0.36,0,-1"));
    expectWavelengths(profile, {383.540, 388.906, 397.008, 410.173, 434.047, 486.135, 656.279}, 0.05);
}

TEST(LaboratoryOnDevice, ACompactDiscIsASpectrometer) {
    const Json::Value profile = profileOf(Arguments{laboratory("spectrometer.json"), "--samples", "4000"} +
                                          line("0.02,0,0.3", "0.09,0,0.3"));
    expectWavelengths(profile, {579.067, 576.961, 546.075, 435.834, 407.784, 404.657}, 0.05);
    for (const Json::Value& maximum : profile["maxima"]) EXPECT_EQ(maximum["order"], -1);
}

// ---- irradiance and spectrum --------------------------------------------------------------------

// A wall under a lamp one metre above the origin, and what else a test puts there.
std::string underALamp(const TestFolder& folder, const std::string& spectrum, const std::string& more = "") {
    const auto path = folder / "lamp.json";
    putBytes(path,
             R"({ "fringe": 1, "camera": { "position": [0, 3, 0], "target": [0, 0, 0], "up": [0, 0, 1] },
        "materials": { "grey": { "type": "conductor", "metal": "gold" } },
        "objects": [ { "name": "table", "type": "rectangle", "center": [0, 0, 0], "u": [0, 0, 1], "v": [1, 0, 0], "material": "grey" })" +
                 more + R"( ],
        "lights": [ { "name": "lamp", "type": "point", "position": [0, 1, 0], "power": "5 W", "spectrum": )" +
                 spectrum + "} ] }");
    return path.string();
}

using Table = std::vector<std::vector<double>>;

// The numbers of a CSV file; its header in `names`.
Table csv(const std::filesystem::path& path, std::vector<std::string>& names) {
    std::ifstream file(path);
    Table table;
    for (std::string row; std::getline(file, row);) {
        if (row.starts_with('#')) continue;
        std::istringstream cells(row);
        std::vector<double> numbers;
        for (std::string cell; std::getline(cells, cell, ',');) {
            if (row.starts_with("position")) names.push_back(cell);
            else numbers.push_back(std::stod(cell));
        }
        if (!numbers.empty()) table.push_back(numbers);
    }
    return table;
}

// The closed form of two slits, beside what the device has: the far field of both, to the 0.4 % by which
// the paraxial fringes drift apart over 4 cm.
TEST(ProfileOnDevice, TheClosedFormOfYoungsFringesIsTheirSecondCurve) {
    const TestFolder folder;
    const auto file = folder / "young.csv", chart = folder / "young.svg";
    expectDone(run(Arguments{"profile", laboratory("young.json"), "--closed-form", "-o", file.string(), "-o",
                             chart.string()} +
                   line("-0.04,0,-2", "0.04,0,-2")));
    std::vector<std::string> names;
    const Table rows = csv(file, names);
    ASSERT_EQ(names.back(), "closed_form_W_m2");
    double peak = 0.0, largest = 0.0;
    for (const std::vector<double>& row : rows) {
        peak = std::max(peak, row[4]);
        largest = std::max(largest, std::abs(row.back() - row[4]));
    }
    EXPECT_GT(peak, 0.0);
    EXPECT_LT(largest, 5e-3 * peak);
    EXPECT_TRUE(std::filesystem::exists(chart));
}

// power / (4 pi distance^2) times the cosine, whatever the surface is made of; and dark behind a ball.
TEST(ProfileOnDevice, IrradianceIsThatOfThePointUnderALamp) {
    const TestFolder folder;
    const std::string scene =
        underALamp(folder, "\"D65\"",
                   R"(, { "type": "sphere", "center": [0.25, 0.5, 0], "radius": 0.01, "material": "grey" })");
    const auto file = folder / "a.csv";
    const Json::Value profile =
        profileOf(Arguments{scene, "--samples", "201", "-o", file.string()} + line("-1,0,0", "1,0,0"));
    EXPECT_EQ(profile["surface"], "table");
    EXPECT_FALSE(profile.isMember("grating"));
    std::vector<std::string> names;
    const Table rows = csv(file, names);
    ASSERT_EQ(rows.size(), 201U);
    ASSERT_EQ(names[4], "irradiance_W_m2");
    int dark = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double x = -1.0 + 2.0 * (static_cast<double>(i) + 0.5) / 201.0;
        EXPECT_NEAR(rows[i][0], x + 1.0, 1e-8);
        EXPECT_NEAR(rows[i][1], x, 1e-8);
        const double squared = 1.0 + x * x;
        const double expected = 5.0 / (4.0 * std::numbers::pi * squared * std::sqrt(squared));
        if (rows[i][4] == 0.0) ++dark;
        else
            EXPECT_NEAR(rows[i][4], expected,
                        1e-5 * expected);  // float32: a dozen roundings of 6e-8, and of tables
    }
    // The ball is halfway to x = 0.5, so its shadow is twice as wide, and it falls in at a cosine of
    // 1/sqrt(1.25).
    EXPECT_NEAR(dark, 4.0 * 0.01 * std::sqrt(1.25) / (2.0 / 201.0), 1.0);
}

// Illuminant E has the same power in every nanometre from 380 to 780 nm.
TEST(ProfileOnDevice, TheSpectrumIsThatOfTheLight) {
    const TestFolder folder;
    const auto file = folder / "a.csv";
    profileOf(Arguments{underALamp(folder, "\"E\""), "--samples", "3", "-o", file.string()} +
              line("-0.1,0,0", "0.1,0,0"));
    std::vector<std::string> names;
    const Table rows = csv(file, names);
    ASSERT_EQ(rows.size(), 3U);
    const double even = rows[1][4] / 400.0;
    ASSERT_EQ(names[6], "E_400nm");
    // Densities are integrated by two Gauss nodes a nanometre. Where the top of a band lies between, |x| over
    // [-1/2, 1/2] is 0.289 instead of 0.25 nm: two slopes of 1/12.5 nm make that 2.5e-4 of a band.
    for (std::size_t i = 6; i < names.size(); ++i) EXPECT_NEAR(rows[1][i], even, 3e-4 * even) << names[i];
    EXPECT_EQ(names.back(), "E_700nm");
}

TEST(ProfileOnDevice, ALinesMeanWavelengthIsItsOwn) {
    const TestFolder folder;
    const auto file = folder / "a.csv";
    profileOf(Arguments{underALamp(folder, R"({ "type": "laser", "wavelength": "632.8 nm" })"), "--samples",
                        "2", "-o", file.string()} +
              line("-0.1,0,0", "0.1,0,0"));
    std::vector<std::string> names;
    const Table rows = csv(file, names);
    ASSERT_EQ(names[5], "mean_wavelength_nm");
    EXPECT_NEAR(rows[0][5], 632.8, 1e-3);
}

TEST(ProfileOnDevice, WritesEveryFormat) {
    const TestFolder folder;
    const Outcome outcome =
        run(Arguments{"profile"} + sodium() + Arguments{"-o", "a.csv", "a.svg", "-o", "b.png"},
            {.folder = folder.path()});
    expectDone(outcome);
    EXPECT_TRUE(contains(outcome.out, "a.csv, a.svg, b.png")) << outcome.out;
    EXPECT_EQ(folder.fileCount(), 3U);
    EXPECT_TRUE(contains(bytesOf(folder / "a.svg"), "</svg>"));
    EXPECT_TRUE(bytesOf(folder / "b.png").starts_with("\x89PNG"));
}

// ---- what cannot be measured --------------------------------------------------------------------

// Refused before a device is looked for: there is none here.
void expectProfileRefused(const Arguments& arguments, const std::vector<std::string>& words) {
    const TestFolder folder;
    const Surroundings noDriver{.folder = folder.path(),
                                .environment = {{"VK_DRIVER_FILES", "/nonexistent"}}};
    expectRefused(run(Arguments{"profile"} + arguments, noDriver), 1, words);
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(Profile, RefusesLinesThatAreNone) {
    const Arguments scene{laboratory("sodium.json")};
    expectProfileRefused(scene + line("0.3,0,-1", "0.3,0,-1"), {"same point", "two ends"});
    expectProfileRefused(scene + line("0.3,0,-0.9", "0.4,0,-1"),
                         {"the beginning of the line, (0.3, 0, -0.9)",
                          "100 mm from the nearest surface, \"wall\"", "(0.3, 0, -1)"});
    expectProfileRefused(scene + line("0.3,0", "0.4,0,-1"), {"--from 0.3,0:", "X,Y,Z"});
    expectProfileRefused(scene + line("0.3,0,-1", "0.4,0,-1,2"), {"--to 0.4,0,-1,2:", "X,Y,Z"});
    expectProfileRefused(scene + line("0.3,0,-1", "nan,0,-1"), {"--to nan,0,-1:"});
    expectProfileRefused(scene + line("0.3,0,-1", "0.4,0,-1") + Arguments{"--samples", "1"}, {"--samples"});
}

TEST(Profile, RefusesGratingsThatAreNone) {
    const Arguments wall = line("0.3,0,-1", "0.4,0,-1");
    expectProfileRefused(Arguments{laboratory("sodium.json"), "--grating", "lattice"} + wall,
                         {"--grating lattice", "gratings with names: grating"});
    expectProfileRefused(Arguments{roomFile()} + line("-0.5,0,-1", "0.5,0,-1"), {"lights[2]", "physical"});
}

TEST(Profile, RefusesFilesThatCannotBeWritten) {
    expectProfileRefused(sodium() + Arguments{"-o", "/nonexistent/a.csv"}, {"/nonexistent/a.csv"});
    expectProfileRefused(sodium() + Arguments{"-o", "a.exr"}, {"a.exr", ".csv, .svg or .png"});
}

}  // namespace
}  // namespace fringe::cli
