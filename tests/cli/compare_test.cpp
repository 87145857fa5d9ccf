// fringe compare: the verdict as exit status, and its numbers.
#include <cmath>

#include "cli/support.hpp"
#include "image/writer.hpp"

namespace fringe::cli {
namespace {

constexpr std::uint32_t kWidth = 20, kHeight = 10;
// Exact in a half, so that the numbers below are too: the film's rounding is far less than a half's.
constexpr float kGrey = 0.5F, kStep = 0.25F;

// a.exr is grey; b.exr differs from it in one pixel, at 7, 3, by 0.25 of green.
class Comparing : public testing::Test {
protected:
    Comparing() {
        image::Image picture{kWidth, kHeight, {}};
        picture.pixels.assign(std::size_t{kWidth} * kHeight, image::filmOf(glm::dvec3(kGrey)));
        image::writeImage(folder_ / "a.exr", picture, {});
        image::writeImage(folder_ / "dim.exr", picture,
                          {.quantity = image::Quantity::luminance, .whiteLuminance = 64.0});
        image::writeImage(folder_ / "bright.exr", picture,
                          {.quantity = image::Quantity::luminance, .whiteLuminance = 96.0});
        picture.pixels[std::size_t{3} * kWidth + 7] = image::filmOf({kGrey, kGrey + kStep, kGrey});
        image::writeImage(folder_ / "b.exr", picture, {});
        picture.pixels.resize(std::size_t{kWidth} * (kHeight - 1));
        picture.height = kHeight - 1;
        image::writeImage(folder_ / "low.exr", picture, {});
    }

    Outcome compare(const Arguments& arguments) {
        return run(Arguments{"compare"} + arguments, {.folder = folder_.path()});
    }

    TestFolder folder_;
};

TEST_F(Comparing, EqualPicturesPass) {
    expectDone(compare({"a.exr", "a.exr"}));
}

TEST_F(Comparing, DifferentPicturesFailWithTheirNumbers) {
    const Outcome outcome = compare({"a.exr", "b.exr"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(contains(outcome.out, "green  max 2.500e-01")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "largest at 7, 3; 1 pixels (0.5000 %) beyond 0")) << outcome.out;
}

TEST_F(Comparing, ToleranceAndAllowanceDecide) {
    EXPECT_EQ(compare({"a.exr", "b.exr", "--tolerance", "0.25"}).status, 0);
    EXPECT_EQ(compare({"a.exr", "b.exr", "--tolerance", "0.2499"}).status, 3);
    EXPECT_EQ(compare({"a.exr", "b.exr", "--allow", "0.005"}).status, 0) << "one pixel of 200";
    EXPECT_EQ(compare({"a.exr", "b.exr", "--allow", "0.0049"}).status, 3);
}

TEST_F(Comparing, JsonHoldsTheSame) {
    const Outcome outcome = compare({"a.exr", "b.exr", "--json"});
    EXPECT_EQ(outcome.status, 3);
    const Json::Value json = parsedJson(outcome.out);
    EXPECT_EQ(json["channels"]["red"]["max"], 0.0);
    EXPECT_EQ(json["channels"]["green"]["max"], 0.25);
    EXPECT_EQ(json["max"], 0.25);
    // One value of 600 is off by 1/4; six digits are what the JSON is for.
    EXPECT_NEAR(json["rmse"].asDouble(), 0.25 / std::sqrt(600.0), 1e-8);
    EXPECT_EQ(json["max_at"][0], 7);
    EXPECT_EQ(json["max_at"][1], 3);
    EXPECT_EQ(json["pixels_beyond"], 1);
    EXPECT_EQ(json["fraction_beyond"], 0.005);
    EXPECT_EQ(json["passed"], false);

    const Json::Value equal = parsedJson(compare({"a.exr", "a.exr", "--json"}).out);
    EXPECT_EQ(equal["passed"], true);
    EXPECT_FALSE(equal.isMember("psnr_db")) << "JSON has no infinity";
}

// Grey of 0.5 is 32 cd/m^2 in one and 48 in the other.
TEST_F(Comparing, AQuantityIsComparedInItsOwnChannel) {
    const Outcome outcome = compare({"dim.exr", "bright.exr"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(contains(outcome.out, "luminance max 1.600e+01  rmse 1.600e+01")) << outcome.out;
    const Json::Value json = parsedJson(compare({"dim.exr", "bright.exr", "--json"}).out);
    EXPECT_EQ(json["channels"].size(), 1U);
    EXPECT_EQ(json["channels"]["luminance"]["max"], 16.0);
}

TEST_F(Comparing, WhatCannotBeComparedIsRefused) {
    expectRefused(compare({"a.exr", "low.exr"}), 1, {"20", "10", "9"});
    expectRefused(compare({"a.exr", "nosuch.exr"}), 1, {"nosuch.exr", "No such file or directory"});
    expectRefused(compare({"a.exr", "dim.exr"}), 1, {"color", "luminance"});
    putBytes(folder_ / "text.png", "this is no picture");
    expectRefused(compare({"a.exr", "text.png"}), 1, {"text.png: "});
    const std::string whole = bytesOf(folder_ / "a.exr");
    putBytes(folder_ / "short.exr", whole.substr(0, whole.size() / 2));
    expectRefused(compare({"short.exr", "a.exr"}), 1, {"short.exr: "});
}

}  // namespace
}  // namespace fringe::cli
