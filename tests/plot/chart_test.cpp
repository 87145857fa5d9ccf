// Charts as files: PNG by its pixels, SVG by its text.
#include "plot/chart.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "image/pictures.hpp"
#include "image/reader.hpp"

namespace fringe::plot {
namespace {

using image::TestFolder;

Chart chart() {
    Chart chart;
    chart.title = "title";
    chart.xLabel = "across";
    chart.yLabel = "up";
    for (int i = 0; i <= 100; ++i) {
        chart.x.push_back(i);
        chart.y.push_back(i == 50 ? 10.0 : 0.0);
    }
    chart.marks = {{50.0, 10.0, "mark"}};
    chart.strip = {{255, 0, 0}, {0, 0, 255}};
    return chart;
}

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Chart, KnowsItsFormats) {
    EXPECT_TRUE(isChartFile("a.svg"));
    EXPECT_TRUE(isChartFile("a.PNG"));
    EXPECT_FALSE(isChartFile("a.csv"));
    EXPECT_FALSE(isChartFile("svg"));
}

TEST(Chart, IsAPngWithTheStripsColoursBelowTheCurve) {
    const TestFolder folder;
    writeChart(folder / "a.png", chart());
    const image::Picture picture = image::readImage(folder / "a.png");
    EXPECT_EQ(picture.width, 1920U);
    EXPECT_EQ(picture.height, 1080U);
    // The strip is 20 points high, 10 above the lower edge, as wide as the frame.
    const image::RgbPixel red = picture.at(400, 1040);
    EXPECT_GT(red.r, 0.9F);
    EXPECT_LT(red.b, 0.1F);
    const image::RgbPixel blue = picture.at(1700, 1040);
    EXPECT_GT(blue.b, 0.9F);
    EXPECT_LT(blue.r, 0.1F);
    EXPECT_GT(picture.at(5, 5).g, 0.99F);  // white around it
}

TEST(Chart, LeavesRoomForAReferenceButNotForAPeakOfIt) {
    const std::vector<double> curve{1.0, 2.0}, dark{0.0, 0.0};
    EXPECT_EQ(highestShown(curve, {}), 2.0);
    EXPECT_EQ(highestShown(curve, dark), 2.0);
    EXPECT_EQ(highestShown(curve, std::vector{0.0, 2.5}), 2.5);
    EXPECT_EQ(highestShown(curve, std::vector{0.0, 100.0}), 3.0);
    EXPECT_EQ(highestShown(dark, std::vector{0.0, 100.0}), 100.0);
}

// Orange, behind the dark blue of the curve: flat at half of its height, where the curve is 0.
TEST(Chart, ShowsTheReference) {
    const TestFolder folder;
    Chart with = chart();
    with.reference = {"reference", std::vector<double>(with.x.size(), 5.0)};
    writeChart(folder / "a.png", with);
    const image::Picture picture = image::readImage(folder / "a.png");
    int orange = 0;
    for (std::uint32_t y = 344; y < 900; ++y) {
        const image::RgbPixel& pixel = picture.at(600, y);
        orange += pixel.r > 0.5F && pixel.b < 0.2F ? 1 : 0;
    }
    EXPECT_GE(orange, 3);  // 2.2 points at two pixels each, less their edges
    EXPECT_LE(orange, 6);
}

TEST(Chart, LeavesRoomForTheLongestLabelUnderTheTitles) {
    const TestFolder folder;
    Chart labelled = chart();
    labelled.title.clear();
    labelled.marks[0].label = "589.5924 nm +- 0.0012 nm (+1) *";
    writeChart(folder / "a.png", labelled);
    const image::Picture picture = image::readImage(folder / "a.png");
    const auto darkest = [&](std::uint32_t from, std::uint32_t to) {
        float least = 1.0F;
        for (std::uint32_t y = from; y < to; ++y)
            for (std::uint32_t x = 0; x < picture.width; ++x) least = std::min(least, picture.at(x, y).g);
        return least;
    };
    EXPECT_GT(darkest(0, 120), 0.99F);  // title, subtitle and legend end at 60 points
    EXPECT_LT(darkest(140, 400), 0.5F);
}

TEST(Chart, IsAnSvgOfLines) {
    const TestFolder folder;
    writeChart(folder / "a.svg", chart());
    const std::string text = textOf(folder / "a.svg");
    EXPECT_NE(text.find("<svg"), std::string::npos);
    EXPECT_NE(text.find("</svg>"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(Chart, OfDarknessAndOfManySamplesIsDrawnAsWell) {
    const TestFolder folder;
    Chart dark = chart();
    for (double& y : dark.y) y = 0.0;
    dark.marks.clear();
    writeChart(folder / "dark.svg", dark);
    EXPECT_EQ(textOf(folder / "dark.svg").find("nan"), std::string::npos);

    Chart many = chart();
    many.x.clear();
    many.y.clear();
    for (int i = 0; i < 50000; ++i) {
        many.x.push_back(i);
        many.y.push_back(i == 31234 ? 10.0 : 1.0);
    }
    many.marks.assign(500, {20000.0, 1.0, "m"});
    writeChart(folder / "many.svg", many);
    // Two points to each quarter of a point of width, not fifty thousand.
    EXPECT_LT(std::filesystem::file_size(folder / "many.svg"), 600'000U);
}

TEST(Chart, LeavesNothingWhereItCannotBeWritten) {
    EXPECT_THROW(writeChart("/nonexistent/a.svg", chart()), image::FileError);
}

}  // namespace
}  // namespace fringe::plot
