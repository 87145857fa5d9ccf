// What is written is what is read, within what the format can hold; and a second decoder agrees.
#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
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

// The film's floats err by 2^-25 of themselves; back in linear sRGB, the absolute values of a row of the
// matrix times white add up to 5.2 at most.
const double kFilmRounding = 5.2 * std::exp2(-25.0);

class PngRoundTrip : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depth, PngRoundTrip, testing::Values(8, 16));

// Half a code value is the rounding of the quantiser; 0.005 covers the float that is read back, whose
// relative error of 2^-24 is at most 0.004 of a code of 16 bit. The curve's slope is up to 12.92.
TEST_P(PngRoundTrip, EncodedValuesAreWithinHalfACode) {
    const TestFolder folder;
    const Picture image = testColors(61, 47);
    writeImage(folder / "a.png", filmOf(image), {.pngBits = GetParam()});
    const Picture read = readImage(folder / "a.png");
    ASSERT_EQ(read.width, image.width);
    ASSERT_EQ(read.height, image.height);
    const double maxCode = GetParam() == 8 ? 255.0 : 65535.0;
    const double bound = 0.5 + 0.005 + maxCode * 12.92 * kFilmRounding;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const RgbPixel &p = image.pixels[i], &q = read.pixels[i];
        EXPECT_NEAR(maxCode * encodeSrgb(q.r), maxCode * encodeSrgb(p.r), bound) << i;
        EXPECT_NEAR(maxCode * encodeSrgb(q.g), maxCode * encodeSrgb(p.g), bound) << i;
        EXPECT_NEAR(maxCode * encodeSrgb(q.b), maxCode * encodeSrgb(p.b), bound) << i;
    }
}

TEST_P(PngRoundTrip, WritingWhatWasReadChangesNothing) {
    const TestFolder folder;
    writeImage(folder / "a.png", testPicture(61, 47), {.pngBits = GetParam()});
    writeImage(folder / "b.png", filmOf(readImage(folder / "a.png")), {.pngBits = GetParam()});
    EXPECT_EQ(bytesOf(folder / "a.png"), bytesOf(folder / "b.png"));
}

// Chunks, checksums, filters and samples by a decoder that knows only Python's zlib.
TEST_P(PngRoundTrip, AnIndependentDecoderAgrees) {
    const TestFolder folder;
    const Image image = testPicture(61, 47);
    const Development brighter{.exposure = 0.5};
    writeImage(folder / "a.png", image,
               {.development = brighter, .pngBits = GetParam(), .metadata = kMetadata});

    std::string samples;  // big-endian, as PNG has them
    if (GetParam() == 8) {
        std::vector<std::uint8_t> codes(3 * image.pixels.size());
        develop8(brighter, image.pixels, codes);
        samples.assign(codes.begin(), codes.end());
    } else {
        std::vector<std::uint16_t> codes(3 * image.pixels.size());
        develop16(brighter, image.pixels, codes);
        for (const unsigned code : codes) {
            samples += static_cast<char>(code >> 8U);
            samples += static_cast<char>(code & 0xFFU);
        }
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
    const Picture image = testColors(61, 47);
    // Exposure is for the display only.
    writeImage(folder / "a.exr", filmOf(image), {.development = {.exposure = 3.0}});
    const Picture read = readImage(folder / "a.exr");
    ASSERT_EQ(read.pixels.size(), image.pixels.size());
    const auto bound = [](float value) {
        return std::max(std::ldexp(std::abs(value), -11), std::ldexp(1.0F, -25)) + kFilmRounding;
    };
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const RgbPixel &p = image.pixels[i], &q = read.pixels[i];
        EXPECT_NEAR(q.r, p.r, bound(p.r)) << i;
        EXPECT_NEAR(q.g, p.g, bound(p.g)) << i;
        EXPECT_NEAR(q.b, p.b, bound(p.b)) << i;
    }
}

// One channel as it stands in the file.
std::vector<float> channelOf(const std::filesystem::path& path, const char* name) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x + 1);
    std::vector<float> values(width * static_cast<std::size_t>(window.max.y + 1));
    Imf::FrameBuffer frame;
    frame.insert(name,
                 Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float), width * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return values;
}

std::vector<std::string> channelNames(const std::filesystem::path& path) {
    const Imf::InputFile file(path.c_str());
    std::vector<std::string> names;
    for (auto at = file.header().channels().begin(); at != file.header().channels().end(); ++at)
        names.emplace_back(at.name());
    return names;
}

TEST(ExrRoundTrip, HalfHoldsNoInfinity) {
    const TestFolder folder;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const Image image{
        2, 1, {{70000.0F, -70000.0F, infinity, false}, {65504.0F, -infinity, std::nanf(""), false}}};
    writeImage(folder / "a.exr", image, {.exrColor = ExrColor::xyz});
    constexpr float largest = 65504.0F;
    EXPECT_EQ(channelOf(folder / "a.exr", "X"), (std::vector<float>{largest, largest}));
    EXPECT_EQ(channelOf(folder / "a.exr", "Y"), (std::vector<float>{-largest, -largest}));
    const std::vector<float> z = channelOf(folder / "a.exr", "Z");
    EXPECT_EQ(z[0], largest);
    EXPECT_TRUE(std::isnan(z[1]));
}

TEST(ExrRoundTrip, FloatXyzIsExact) {
    const TestFolder folder;
    Image image = testPicture(61, 47);
    image.pixels[5].x = -1e30F;
    image.pixels[6].x = std::numeric_limits<float>::denorm_min();
    image.pixels[7].x = std::numeric_limits<float>::infinity();
    writeImage(folder / "a.exr", image, {.exrColor = ExrColor::xyz, .exrFloat = true});
    EXPECT_EQ(channelNames(folder / "a.exr"), (std::vector<std::string>{"X", "Y", "Z"}));
    const auto x = channelOf(folder / "a.exr", "X"), y = channelOf(folder / "a.exr", "Y"),
               z = channelOf(folder / "a.exr", "Z");
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        EXPECT_EQ(x[i], image.pixels[i].x) << i;
        EXPECT_EQ(y[i], image.pixels[i].y) << i;
        EXPECT_EQ(z[i], image.pixels[i].z) << i;
    }
}

// Both are read as linear sRGB; the floats of the two ways differ by the film's rounding and one of their
// own.
TEST(ExrRoundTrip, RgbAndXyzAreTheSameColors) {
    const TestFolder folder;
    const Picture colors = testColors(61, 47);
    writeImage(folder / "rgb.exr", filmOf(colors), {.exrFloat = true});
    writeImage(folder / "xyz.exr", filmOf(colors), {.exrColor = ExrColor::xyz, .exrFloat = true});
    EXPECT_EQ(channelNames(folder / "rgb.exr"), (std::vector<std::string>{"B", "G", "R"}));
    const double bound = kFilmRounding + std::exp2(-24.0);
    for (const char* name : {"rgb.exr", "xyz.exr"}) {
        const Picture read = readImage(folder / name);
        EXPECT_EQ(read.quantity, Quantity::color);
        for (std::size_t i = 0; i < colors.pixels.size(); ++i) {
            EXPECT_NEAR(read.pixels[i].r, colors.pixels[i].r, bound) << i;
            EXPECT_NEAR(read.pixels[i].g, colors.pixels[i].g, bound) << i;
            EXPECT_NEAR(read.pixels[i].b, colors.pixels[i].b, bound) << i;
        }
    }
}

TEST(ExrColors, StateTheirPrimariesAndTheLuminanceOfWhite) {
    const TestFolder folder;
    writeImage(folder / "a.exr", testPicture(3, 2), {.whiteLuminance = 205.0});
    const Imf::InputFile file((folder / "a.exr").c_str());
    ASSERT_TRUE(Imf::hasChromaticities(file.header()));
    const Imf::Chromaticities& stated = Imf::chromaticities(file.header());
    const auto primary = primaries(ColorSpace::srgb);
    EXPECT_EQ(stated.red, Imath::V2f(static_cast<float>(primary[0].x), static_cast<float>(primary[0].y)));
    EXPECT_EQ(stated.green, Imath::V2f(static_cast<float>(primary[1].x), static_cast<float>(primary[1].y)));
    EXPECT_EQ(stated.blue, Imath::V2f(static_cast<float>(primary[2].x), static_cast<float>(primary[2].y)));
    EXPECT_EQ(stated.white, Imath::V2f(0.3127F, 0.3290F));
    EXPECT_EQ(Imf::whiteLuminance(file.header()), 205.0F);
    writeImage(folder / "xyz.exr", testPicture(3, 2), {.exrColor = ExrColor::xyz});
    const Imf::InputFile xyz((folder / "xyz.exr").c_str());
    EXPECT_FALSE(Imf::hasChromaticities(xyz.header()));
    EXPECT_FALSE(Imf::hasWhiteLuminance(xyz.header()));
}

class Quantities : public testing::TestWithParam<Quantity> {};
INSTANTIATE_TEST_SUITE_P(All, Quantities,
                         testing::Values(Quantity::luminance, Quantity::radiance, Quantity::irradiance),
                         [](const auto& chosen) { return std::string(nameOf(chosen.param)); });

// Luminance is Y in cd/m^2: one float product, which rounds by 2^-24. The others are y as it stands.
TEST_P(Quantities, HaveOneChannelOfTheirNameWithItsUnit) {
    const TestFolder folder;
    const Image image = testPicture(19, 33);
    const OutputOptions options{.quantity = GetParam(), .whiteLuminance = 205.0, .exrFloat = true};
    writeImage(folder / "a.exr", image, options);
    EXPECT_EQ(channelNames(folder / "a.exr"), (std::vector<std::string>{nameOf(GetParam())}));
    const Picture read = readImage(folder / "a.exr");
    EXPECT_EQ(read.quantity, GetParam());
    const double factor = GetParam() == Quantity::luminance ? 205.0 : 1.0;
    const double error = GetParam() == Quantity::luminance ? std::exp2(-24.0) : 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double expected = factor * image.pixels[i].y;
        EXPECT_NEAR(read.pixels[i].r, expected, error * expected) << i;
        EXPECT_EQ(read.pixels[i].r, read.pixels[i].b) << i;
    }
    EXPECT_EQ(readMetadata(folder / "a.exr"), (Metadata{{"unit", unitOf(GetParam())}}));
}

TEST_P(Quantities, FitHalvesToo) {
    const TestFolder folder;
    const Image image = testPicture(19, 33);
    writeImage(folder / "a.exr", image, {.quantity = GetParam(), .whiteLuminance = 1.0});
    const Picture read = readImage(folder / "a.exr");
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        EXPECT_NEAR(read.pixels[i].g, image.pixels[i].y, std::ldexp(image.pixels[i].y, -11) + 1e-7) << i;
}

TEST_P(Quantities, AreNoPng) {
    const TestFolder folder;
    try {
        writeImage(folder / "a.png", testPicture(3, 2), {.quantity = GetParam(), .whiteLuminance = 1.0});
        FAIL() << "written";
    } catch (const FileError& error) {
        EXPECT_EQ(error.what(), (folder / "a.png").string() + ": a PNG file holds colours only; give " +
                                    nameOf(GetParam()) + " a name that ends in .exr");
    }
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(QuantityUnits, AreThoseOfTheSi) {
    EXPECT_STREQ(unitOf(Quantity::luminance), "cd/m^2");
    EXPECT_STREQ(unitOf(Quantity::radiance), "W/(m^2 sr)");
    EXPECT_STREQ(unitOf(Quantity::irradiance), "W/m^2");
}

class ExrMarks : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Float, ExrMarks, testing::Bool());

TEST_P(ExrMarks, TravelInAChannelOfTheirOwnWhenAskedTo) {
    const TestFolder folder;
    Image image = testPicture(19, 33);
    for (std::size_t i = 0; i < image.pixels.size(); i += 7) image.pixels[i] = {0.0F, 0.0F, 0.0F, true};
    writeImage(folder / "with.exr", image, {.exrFloat = GetParam(), .nonFiniteChannel = true});
    writeImage(folder / "without.exr", image, {.exrFloat = GetParam()});
    const Picture with = readImage(folder / "with.exr"), without = readImage(folder / "without.exr");
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
    EXPECT_FALSE(isMetadataKey("unit"));
}

}  // namespace
}  // namespace fringe::image
