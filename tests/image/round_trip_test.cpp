// What is written is what is read, within what the format can hold; and a second decoder agrees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "image/develop.hpp"
#include "image/pictures.hpp"
#include "image/reader.hpp"
#include "image/writer.hpp"

namespace fringe::image {
namespace {

// A scene file of 100 kB, in which no two lines are alike.
std::string longText(const std::string& ornament) {
    std::mt19937 random(1);
    std::string text;
    while (text.size() < 100'000)
        text += "  \"key\": " + std::to_string(random()) + ", // " + ornament + "\n";
    return text;
}

// Keys in alphabetical order: EXR sorts them.
const Metadata kMetadata = {
    {"Comment", ""},
    {"Software", "Fringe 0.1.0"},
    {"fringe.options", "-o \"b\xC3\xBChne.png\" \xE2\x88\x9E"},  // UTF-8: ü and the sign for infinity
    {"fringe.scene", longText("ascii")},
    {"fringe.scene utf-8", longText("\xC2\xB5m")},
};

class PngRoundTrip : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depth, PngRoundTrip, testing::Values(8, 16));

// Half a code value is the rounding of the quantiser; 0.005 covers the float that is read back, whose
// relative error of 2^-24 is at most 0.004 of a code of 16 bit.
TEST_P(PngRoundTrip, EncodedValuesAreWithinHalfACode) {
    const TestFolder folder;
    const Image image = testPicture(61, 47);
    writeImage(folder / "a.png", image, {.pngBits = GetParam()});
    const Image read = readImage(folder / "a.png");
    ASSERT_EQ(read.width, image.width);
    ASSERT_EQ(read.height, image.height);
    const double maxCode = GetParam() == 8 ? 255.0 : 65535.0, bound = 0.5 + 0.005;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Pixel &p = image.pixels[i], &q = read.pixels[i];
        EXPECT_NEAR(maxCode * encodeSrgb(q.r), maxCode * encodeSrgb(std::min(p.r, 1.0F)), bound) << i;
        EXPECT_NEAR(maxCode * encodeSrgb(q.g), maxCode * encodeSrgb(p.g), bound) << i;
        EXPECT_NEAR(maxCode * encodeSrgb(q.b), maxCode * encodeSrgb(p.b), bound) << i;
    }
}

TEST_P(PngRoundTrip, WritingWhatWasReadChangesNothing) {
    const TestFolder folder;
    writeImage(folder / "a.png", testPicture(61, 47), {.pngBits = GetParam()});
    writeImage(folder / "b.png", readImage(folder / "a.png"), {.pngBits = GetParam()});
    EXPECT_EQ(bytesOf(folder / "a.png"), bytesOf(folder / "b.png"));
}

// Chunks, checksums, filters and samples by a decoder that knows only Python's zlib.
TEST_P(PngRoundTrip, AnIndependentDecoderAgrees) {
    const TestFolder folder;
    const Image image = testPicture(61, 47);
    writeImage(folder / "a.png", image, {.exposure = 0.5, .pngBits = GetParam(), .metadata = kMetadata});

    std::string samples;  // big-endian, as PNG has them
    for (const Pixel& pixel : image.pixels)
        for (const float value : {pixel.r, pixel.g, pixel.b}) {
            const double shown = std::clamp(value * std::exp2(0.5), 0.0, 1.0);
            const auto code =
                static_cast<unsigned>(std::floor((GetParam() == 8 ? 255 : 65535) * encodeSrgb(shown) + 0.5));
            if (GetParam() == 16) samples += static_cast<char>(code >> 8U);
            samples += static_cast<char>(code & 0xFFU);
        }
    putBytes(folder / "samples", samples);
    std::string texts;
    for (const auto& [key, value] : kMetadata) texts += key + '\0' + value + '\0';
    putBytes(folder / "texts", texts);

    const std::string command = "python3 " FRINGE_SOURCE_DIR "/tests/image/check_png.py " +
                                (folder / "a.png").string() + " 61 47 " + std::to_string(GetParam()) + " " +
                                (folder / "samples").string() + " " + (folder / "texts").string();
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

// Half has 11 bits of precision, so rounding errs by 2^-11 of a normal value, and by 2^-25 below 2^-14.
TEST(ExrRoundTrip, HalfKeepsElevenBits) {
    const TestFolder folder;
    const Image image = testPicture(61, 47);
    writeImage(folder / "a.exr", image, {.exposure = 3.0});  // exposure is for the display only
    const Image read = readImage(folder / "a.exr");
    ASSERT_EQ(read.pixels.size(), image.pixels.size());
    const auto bound = [](float value) {
        return std::max(std::ldexp(std::abs(value), -11), std::ldexp(1.0F, -25));
    };
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Pixel &p = image.pixels[i], &q = read.pixels[i];
        EXPECT_NEAR(q.r, p.r, bound(p.r)) << i;
        EXPECT_NEAR(q.g, p.g, bound(p.g)) << i;
        EXPECT_NEAR(q.b, p.b, bound(p.b)) << i;
    }
}

TEST(ExrRoundTrip, HalfHoldsNoInfinity) {
    const TestFolder folder;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Image image{
        2, 1, {{70000.0F, -70000.0F, infinity, false}, {65504.0F, -infinity, std::nanf(""), false}}};
    writeImage(folder / "a.exr", image, {});
    const Image read = readImage(folder / "a.exr");
    constexpr float largest = 65504.0F;
    EXPECT_EQ(read.pixels[0].r, largest);
    EXPECT_EQ(read.pixels[0].g, -largest);
    EXPECT_EQ(read.pixels[0].b, largest);
    EXPECT_EQ(read.pixels[1].r, largest);
    EXPECT_EQ(read.pixels[1].g, -largest);
    EXPECT_TRUE(std::isnan(read.pixels[1].b));
}

TEST(ExrRoundTrip, FloatIsExact) {
    const TestFolder folder;
    Image image = testPicture(61, 47);
    image.pixels[5].r = -1e30F;
    image.pixels[6].r = std::numeric_limits<float>::denorm_min();
    image.pixels[7].r = std::numeric_limits<float>::infinity();
    writeImage(folder / "a.exr", image, {.exrFloat = true});
    const Image read = readImage(folder / "a.exr");
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        EXPECT_EQ(read.pixels[i].r, image.pixels[i].r) << i;
        EXPECT_EQ(read.pixels[i].g, image.pixels[i].g) << i;
        EXPECT_EQ(read.pixels[i].b, image.pixels[i].b) << i;
    }
}

class ExrMarks : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Float, ExrMarks, testing::Bool());

TEST_P(ExrMarks, TravelInAChannelOfTheirOwnWhenAskedTo) {
    const TestFolder folder;
    Image image = testPicture(19, 33);
    for (std::size_t i = 0; i < image.pixels.size(); i += 7) image.pixels[i] = {0.0F, 0.0F, 0.0F, true};
    writeImage(folder / "with.exr", image, {.exrFloat = GetParam(), .nonFiniteChannel = true});
    writeImage(folder / "without.exr", image, {.exrFloat = GetParam()});
    const Image with = readImage(folder / "with.exr"), without = readImage(folder / "without.exr");
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        EXPECT_EQ(with.pixels[i].nonFinite, image.pixels[i].nonFinite) << i;
        EXPECT_FALSE(without.pixels[i].nonFinite) << i;
    }
    EXPECT_EQ(bytesOf(folder / "without.exr").find("nonfinite"), std::string::npos);
}

class MetadataRoundTrip : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Format, MetadataRoundTrip, testing::Values("a.png", "a.exr"));

TEST_P(MetadataRoundTrip, TextsArriveWhole) {
    const TestFolder folder;
    writeImage(folder / GetParam(), testPicture(3, 2), {.metadata = kMetadata});
    EXPECT_EQ(readMetadata(folder / GetParam()), kMetadata);
}

TEST_P(MetadataRoundTrip, NoneIsFine) {
    const TestFolder folder;
    writeImage(folder / GetParam(), testPicture(3, 2), {});
    EXPECT_EQ(readMetadata(folder / GetParam()), Metadata{});
}

TEST(MetadataKeys, AreThoseThatBothFormatsHold) {
    EXPECT_TRUE(isMetadataKey("fringe.scene file"));
    EXPECT_TRUE(isMetadataKey(std::string(79, 'k')));
    EXPECT_FALSE(isMetadataKey(std::string(80, 'k')));
    EXPECT_FALSE(isMetadataKey(""));
    EXPECT_FALSE(isMetadataKey(" k"));
    EXPECT_FALSE(isMetadataKey("k "));
    EXPECT_FALSE(isMetadataKey("two  spaces"));
    EXPECT_FALSE(isMetadataKey("line\nbreak"));
    EXPECT_FALSE(isMetadataKey("caf\xC3\xA9"));
    EXPECT_FALSE(isMetadataKey("channels"));
}

}  // namespace
}  // namespace fringe::image
