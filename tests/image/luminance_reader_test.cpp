// Pictures of luminance: every kind of PNG against the formula of sRGB.
#include "image/luminance_reader.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace fringe::image {
namespace {

// A file of the simplified interface of libpng, which is gone at the end of the test.
class File {
public:
    File(std::uint32_t format, std::uint32_t width, std::uint32_t height, const void* codes)
        : path(testing::TempDir() + "luminance_" +
               testing::UnitTest::GetInstance()->current_test_info()->name() + ".png") {
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        png.width = width;
        png.height = height;
        png.format = format;
        EXPECT_NE(png_image_write_to_file(&png, path.c_str(), 0, codes, 0, nullptr), 0) << png.message;
    }
    ~File() { std::filesystem::remove(path); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    std::string path;
};

// IEC 61966-2-1, above its linear part.
double linear(double code) {
    return std::pow((code / 255.0 + 0.055) / 1.055, 2.4);
}

constexpr float kSingle = 1e-7F;  // rounding to single precision, of values up to 1

TEST(LuminanceReader, GreyOfEightBits) {
    const std::uint8_t codes[] = {0, 255, 188, 100, 64, 200};
    const File file(PNG_FORMAT_GRAY, 3, 2, codes);
    const LuminancePicture picture = readLuminance(file.path);
    EXPECT_EQ(picture.width, 3U);
    EXPECT_EQ(picture.height, 2U);
    ASSERT_EQ(picture.values.size(), 6U);
    EXPECT_EQ(picture.values[0], 0.0F);
    EXPECT_NEAR(picture.values[1], 1.0, kSingle);
    for (const std::size_t i : {2, 3, 4, 5}) EXPECT_NEAR(picture.values[i], linear(codes[i]), kSingle) << i;
}

TEST(LuminanceReader, ColorsHaveTheWeightsOfTheirPrimaries) {
    const std::uint8_t codes[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 188, 100, 64};
    const File file(PNG_FORMAT_RGB, 4, 1, codes);
    const LuminancePicture picture = readLuminance(file.path);
    EXPECT_NEAR(picture.values[0], 0.2126, kSingle);
    EXPECT_NEAR(picture.values[1], 0.7152, kSingle);
    EXPECT_NEAR(picture.values[2], 0.0722, kSingle);
    EXPECT_NEAR(picture.values[3], 0.2126 * linear(188) + 0.7152 * linear(100) + 0.0722 * linear(64),
                kSingle);
}

TEST(LuminanceReader, TransparentIsBlack) {
    const std::uint8_t codes[] = {255, 255, 255, 0, 255, 255, 255, 255};
    const File file(PNG_FORMAT_RGBA, 2, 1, codes);
    const LuminancePicture picture = readLuminance(file.path);
    EXPECT_EQ(picture.values[0], 0.0F);
    EXPECT_NEAR(picture.values[1], 1.0, kSingle);
}

TEST(LuminanceReader, SixteenBitsKeepTheirPrecision) {
    const std::uint16_t codes[] = {0, 65535, 32768, 1000};  // linear; libpng notes so in the file
    const File file(PNG_FORMAT_LINEAR_Y, 4, 1, codes);
    const LuminancePicture picture = readLuminance(file.path);
    for (const std::size_t i : {0, 1, 2, 3}) {
        EXPECT_NEAR(picture.values[i], codes[i] / 65535.0, 2.0 / 65535.0) << i;  // libpng's own rounding
    }
}

TEST(LuminanceReader, FilesThatAreNone) {
    EXPECT_THROW(readLuminance("no such file.png"), FileError);
    EXPECT_THROW(readLuminance(testing::TempDir()), FileError);
    const std::string path = testing::TempDir() + "luminance_reader_text.png";
    std::ofstream(path) << "no picture";
    EXPECT_THROW(readLuminance(path), FileError);
    std::filesystem::remove(path);
    const std::vector<std::uint8_t> wide(4097, 255);
    const File file(PNG_FORMAT_GRAY, 4097, 1, wide.data());
    try {
        readLuminance(file.path);
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(error.what(), file.path + ": has 4097 x 1 pixels; write at most 4096 x 4096");
    }
}

TEST(LuminanceReader, TruncatedFilesAreRefused) {
    const std::vector<std::uint8_t> codes(100U * 100U, 128);
    const File file(PNG_FORMAT_GRAY, 100, 100, codes.data());
    std::filesystem::resize_file(file.path, std::filesystem::file_size(file.path) / 2);
    EXPECT_THROW(readLuminance(file.path), FileError);
}

}  // namespace
}  // namespace fringe::image
