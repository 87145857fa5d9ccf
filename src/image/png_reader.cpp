// PNG by libpng, to linear sRGB. Memory grows with the rows that decode, so that a corrupt header cannot
// ask for more than the file can fill.
#include <png.h>

#include <bit>
#include <cstdio>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "image/develop.hpp"
#include "image/formats.hpp"
#include "image/png_guard.hpp"

namespace fringe::image {

namespace {

constexpr std::size_t kMaxTextBytes = std::size_t{64}
                                      << 20U;  // of one text; more is taken for a decompression bomb

// libpng's two structures, usable from constructor to destructor.
struct Handle {
    Handle()
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, onPngError, ignorePngWarning)),
          info(png_create_info_struct(png)) {
        if (info == nullptr) {
            png_destroy_read_struct(&png, nullptr, nullptr);
            throw std::bad_alloc();
        }
    }
    ~Handle() { png_destroy_read_struct(&png, &info, nullptr); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    PngMessage message{};
    png_structp png;
    png_infop info;
};

// A PNG file whose header, up to the pixels, has been read.
class Decoder {
public:
    Decoder(std::FILE* stream, std::filesystem::path path);

    Image readPixels();
    Metadata texts() const;

private:
    template <class Step>
    void require(const Step& step) {
        if (!guarded(handle_.png, step))
            throw FileError(path_, std::string("is truncated or corrupt: ") + handle_.message.data());
    }

    std::filesystem::path path_;
    Handle handle_;
};

Decoder::Decoder(std::FILE* stream, std::filesystem::path path) : path_(std::move(path)) {
    require([&] {
        png_init_io(handle_.png, stream);
        png_set_chunk_malloc_max(handle_.png, kMaxTextBytes);
        png_read_info(handle_.png, handle_.info);
    });
}

// The linear value of every code of 8 or 16 bits.
std::vector<float> linearOfCodes(int bits) {
    std::vector<float> linear(std::size_t{1} << static_cast<unsigned>(bits));
    const auto maxCode = static_cast<double>(linear.size() - 1);
    for (std::size_t code = 0; code < linear.size(); ++code)
        linear[code] = static_cast<float>(decodeSrgb(static_cast<double>(code) / maxCode));
    return linear;
}

template <class Code>
void appendRow(const std::vector<Code>& rgb, const std::vector<float>& linear, std::vector<Pixel>& pixels) {
    for (std::size_t i = 0; i < rgb.size(); i += 3)
        pixels.push_back({linear[rgb[i]], linear[rgb[i + 1]], linear[rgb[i + 2]], false});
}

Image Decoder::readPixels() {
    const png_structp png = handle_.png;
    const png_infop info = handle_.info;
    Image image{png_get_image_width(png, info), png_get_image_height(png, info), {}};
    requireReadableSize(path_, image.width, image.height);
    if (png_get_interlace_type(png, info) != PNG_INTERLACE_NONE)
        throw FileError(path_, "is an interlaced PNG; save it without interlacing");

    // Whatever the file holds arrives as RGB of 8 or 16 bits in the machine's byte order.
    const bool isDeep = png_get_bit_depth(png, info) == 16;
    require([&] {
        png_set_expand(png);
        png_set_gray_to_rgb(png);
        png_set_strip_alpha(png);
        if (std::endian::native == std::endian::little) png_set_swap(png);
        png_read_update_info(png, info);
    });

    const std::vector<float> linear = linearOfCodes(isDeep ? 16 : 8);
    std::vector<std::uint8_t> row8(isDeep ? 0 : std::size_t{3} * image.width);
    std::vector<std::uint16_t> row16(isDeep ? std::size_t{3} * image.width : 0);
    const auto row = isDeep ? reinterpret_cast<png_bytep>(row16.data()) : row8.data();
    for (std::uint32_t y = 0; y < image.height; ++y) {
        require([&] { png_read_row(png, row, nullptr); });
        isDeep ? appendRow(row16, linear, image.pixels) : appendRow(row8, linear, image.pixels);
    }
    require([&] { png_read_end(png, nullptr); });
    return image;
}

std::string utf8OfLatin1(const char* text) {
    std::string utf8;
    for (; *text != '\0'; ++text) {
        const auto code = static_cast<unsigned char>(*text);
        if (code < 0x80) {
            utf8 += *text;
        } else {
            utf8 += static_cast<char>(0xC0 | (code >> 6));
            utf8 += static_cast<char>(0x80 | (code & 0x3F));
        }
    }
    return utf8;
}

Metadata Decoder::texts() const {
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(handle_.png, handle_.info, &texts, &count);
    Metadata metadata;
    for (const png_text& text : std::span(texts, static_cast<std::size_t>(count))) {
        const bool isUtf8 = text.compression >= PNG_ITXT_COMPRESSION_NONE;  // the other kinds are Latin-1
        metadata.emplace_back(text.key, isUtf8 ? std::string(text.text) : utf8OfLatin1(text.text));
    }
    return metadata;
}

}  // namespace

Image readPng(std::FILE* stream, const std::filesystem::path& path) {
    return Decoder(stream, path).readPixels();
}

Metadata readPngMetadata(std::FILE* stream, const std::filesystem::path& path) {
    return Decoder(stream, path).texts();
}

}  // namespace fringe::image
