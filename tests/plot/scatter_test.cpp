// Points on logarithmic axes as files.
#include "plot/scatter.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "image/pictures.hpp"
#include "image/reader.hpp"

namespace fringe::plot {
namespace {

using image::TestFolder;

Scatter scatter() {
    return {.title = "title",
            .subtitle = "subtitle",
            .xLabel = "across",
            .yLabel = "up",
            .series = {{"first", {{1.0, 1e-2, "a"}, {10.0, 1e-4, "b"}}}, {"second", {{20.0, 1e-3, "c"}}}},
            .fronts = {{{1.0, 1e-2, "a"}, {10.0, 1e-4, "b"}}}};
}

std::string svgOf(const Scatter& scatter) {
    const TestFolder folder;
    writeScatter(folder / "a.svg", scatter);
    std::ifstream file(folder / "a.svg");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Scatter, DrawsTheSeriesInTheirColours) {
    const TestFolder folder;
    writeScatter(folder / "a.png", scatter());
    const image::Picture picture = image::readImage(folder / "a.png");
    ASSERT_EQ(picture.width, 1920U);
    // The lower left corner of the frame is at (88, 480) points; x covers 1 to 100, y 1e-4 to 1e-2, so that
    // (10, 1e-4) is in the middle of the lower edge, and (1, 1e-2) in the upper left corner at (88, 60).
    const image::RgbPixel corner = picture.at(2 * 88, 2 * 60),
                          middle = picture.at(2 * (88 + 642 / 2), 2 * 480);
    for (const image::RgbPixel& dot : {corner, middle}) {
        EXPECT_LT(dot.r, 0.1F);
        EXPECT_GT(dot.b, 0.4F);
    }
}

TEST(Scatter, NeedsNoFrontAndOnePointIsEnough) {
    Scatter one = scatter();
    one.series = {{"only", {{3.0, 5.0, "x"}}}};
    one.fronts.clear();
    EXPECT_EQ(countOf(svgOf(one), "nan"), 0U);
}

TEST(Scatter, LabelsTheFrontAlone) {
    Scatter without = scatter();
    without.fronts.clear();
    EXPECT_GT(svgOf(scatter()).size(), svgOf(without).size());
    // Several are drawn without labels: a line and two rings in place of two words.
    Scatter twice = scatter();
    twice.fronts.push_back(twice.fronts.front());
    EXPECT_LT(countOf(svgOf(twice), "<use"), countOf(svgOf(scatter()), "<use"));
}

TEST(Scatter, LeavesNothingWhereItCannotBeWritten) {
    EXPECT_THROW(writeScatter("/nonexistent/a.svg", scatter()), image::FileError);
}

}  // namespace
}  // namespace fringe::plot
