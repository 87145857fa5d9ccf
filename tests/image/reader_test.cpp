// Files that Fringe did not write: other layouts, and files that are damaged or no pictures at all.
#include "image/reader.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <vector>

#include "image/color_space.hpp"
#include "image/pictures.hpp"
#include "image/writer.hpp"

namespace fringe::image {
namespace {

std::string messageOfReading(const std::filesystem::path& path) {
    try {
        readImage(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "(no error)";
}

struct ForeignPng {
    int colourType, bits, interlace;
    std::uint32_t width;
    std::vector<std::vector<png_byte>> rows;
};

void writeForeign(const std::filesystem::path& path, const ForeignPng& picture) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, picture.width, static_cast<png_uint_32>(picture.rows.size()), picture.bits,
                 picture.colourType, picture.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const png_color palette[] = {{0, 0, 0}, {255, 128, 0}};
    if (picture.colourType == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, palette, 2);
    char key[] = "Author", value[] = "Andr\xE9";  // Latin-1, as a tEXt chunk has it
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key;
    text.text = value;
    png_set_text(png, info, &text, 1);
    png_write_info(png, info);
    for (int pass = png_set_interlace_handling(png); pass > 0; --pass)
        for (const auto& row : picture.rows) png_write_row(png, row.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

TEST(ReadPng, GrayOfOneBit) {
    const TestFolder folder;
    writeForeign(folder / "a.png", {PNG_COLOR_TYPE_GRAY, 1, PNG_INTERLACE_NONE, 3, {{0b0100'0000}}});
    const Picture image = readImage(folder / "a.png");
    ASSERT_EQ(image.pixels.size(), 3U);
    EXPECT_EQ(image.pixels[0].g, 0.0F);
    EXPECT_EQ(image.pixels[1].g, 1.0F);
    EXPECT_EQ(image.pixels[1].b, 1.0F);
}

TEST(ReadPng, Palette) {
    const TestFolder folder;
    writeForeign(folder / "a.png", {PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_NONE, 2, {{1, 0}}});
    const Picture image = readImage(folder / "a.png");
    EXPECT_EQ(image.pixels[0].r, 1.0F);
    EXPECT_EQ(image.pixels[0].g, static_cast<float>(decodeSrgb(128.0 / 255.0)));
    EXPECT_EQ(image.pixels[1].r, 0.0F);
}

TEST(ReadPng, AlphaIsIgnored) {
    const TestFolder folder;
    writeForeign(folder / "a.png", {PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_NONE, 1, {{255, 128, 0, 7}}});
    const Picture image = readImage(folder / "a.png");
    EXPECT_EQ(image.pixels[0].r, 1.0F);
    EXPECT_EQ(image.pixels[0].g, static_cast<float>(decodeSrgb(128.0 / 255.0)));
    EXPECT_EQ(image.pixels[0].b, 0.0F);
}

TEST(ReadPng, InterlacedIsRefused) {
    const TestFolder folder;
    writeForeign(folder / "a.png", {PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_ADAM7, 2, {{1, 2}, {3, 4}}});
    EXPECT_EQ(messageOfReading(folder / "a.png"),
              (folder / "a.png").string() + ": is an interlaced PNG; save it without interlacing");
}

TEST(ReadPng, Latin1TextBecomesUtf8) {
    const TestFolder folder;
    writeForeign(folder / "a.png", {PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE, 1, {{0}}});
    EXPECT_EQ(readMetadata(folder / "a.png"), (Metadata{{"Author", "Andr\xC3\xA9"}}));
}

// A file with the given channels, each holding 1, 2, 3, ... over the window x 10..11, y -3..-1.
void writeForeign(const std::filesystem::path& path, const std::vector<std::string>& channels, int sampling) {
    const Imath::Box2i window({10, -4}, {11, -1});
    Imf::Header header(window, window);
    std::vector<float> values(8);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i + 1);
    Imf::FrameBuffer frame;
    for (const std::string& channel : channels) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT, sampling, sampling));
        frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), window, sizeof(float),
                                               2 * sizeof(float), sampling, sampling));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(4);
}

TEST(ReadExr, AWindowAwayFromTheOriginAndMoreChannels) {
    const TestFolder folder;
    writeForeign(folder / "a.exr", {"A", "B", "G", "R", "Z"}, 1);
    const Picture image = readImage(folder / "a.exr");
    ASSERT_EQ(image.width, 2U);
    ASSERT_EQ(image.height, 4U);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(image.pixels[i].r, static_cast<float>(i + 1));
        EXPECT_EQ(image.pixels[i].b, static_cast<float>(i + 1));
    }
}

TEST(ReadExr, OtherLayoutsAreRefused) {
    const TestFolder folder;
    const auto path = folder / "a.exr";
    writeForeign(path, {"Y"}, 1);
    EXPECT_EQ(messageOfReading(path),
              path.string() +
                  ": has none of the channels that are read: R, G and B; X, Y and Z; luminance, "
                  "radiance or irradiance");
    writeForeign(path, {"R", "B"}, 1);
    EXPECT_EQ(messageOfReading(path), path.string() + ": has no channel G beside the others");
    writeForeign(path, {"R", "G", "B"}, 2);
    EXPECT_EQ(messageOfReading(path), path.string() + ": has channel R at less than full resolution");
}

TEST(ReadAnything, WhatIsNoPictureIsRefused) {
    const TestFolder folder;
    const auto path = folder / "a.png";
    EXPECT_EQ(messageOfReading(path), path.string() + ": cannot be read: No such file or directory");
    EXPECT_EQ(messageOfReading(folder.path()), folder.path().string() + ": cannot be read: Is a directory");
    for (const char* content : {"", "\x89PN", "P6 3 2 255 pixels"}) {
        putBytes(path, content);
        EXPECT_EQ(messageOfReading(path), path.string() + ": is neither a PNG nor an EXR file");
        EXPECT_THROW(readMetadata(path), FileError);
    }
}

TEST(ReadAnything, TheContentDecidesNotTheName) {
    const TestFolder folder;
    writeImage(folder / "a.exr", testPicture(3, 2), {});
    std::filesystem::rename(folder / "a.exr", folder / "a.png");
    EXPECT_EQ(readImage(folder / "a.png").width, 3U);
}

class Damaged : public testing::TestWithParam<const char*> {
protected:
    Damaged() {
        writeImage(path_, testPicture(40, 35),
                   {.nonFiniteChannel = true, .metadata = {{"Software", "Fringe"}}});
        whole_ = bytesOf(path_);
    }

    TestFolder folder_;
    std::filesystem::path path_ = folder_ / GetParam();
    std::string whole_;
};
INSTANTIATE_TEST_SUITE_P(Format, Damaged, testing::Values("a.png", "a.exr"));

TEST_P(Damaged, EveryTruncationIsAnError) {
    for (std::size_t size = 0; size < whole_.size(); ++size) {
        putBytes(path_, whole_.substr(0, size));
        EXPECT_THROW(readImage(path_), FileError) << size << " of " << whole_.size() << " bytes";
    }
}

// A changed byte may be harmless (a text) or not; either way nothing but a FileError may come of it.
TEST_P(Damaged, NoChangedByteDoesMoreThanAnError) {
    for (std::size_t at = 0; at < whole_.size(); ++at) {
        std::string damaged = whole_;
        damaged[at] = static_cast<char>(damaged[at] ^ (at % 2 == 0 ? 0xFF : 0x40));
        putBytes(path_, damaged);
        try {
            readImage(path_);
            readMetadata(path_);
        } catch (const FileError&) {
        }
    }
}

TEST_P(Damaged, TheMessageNamesTheFile) {
    putBytes(path_, whole_.substr(0, whole_.size() / 2));
    EXPECT_EQ(messageOfReading(path_).rfind(path_.string() + ": is truncated or corrupt: ", 0), 0U)
        << messageOfReading(path_);
}

}  // namespace
}  // namespace fringe::image
