// PNG by libpng, to linear sRGB, by way of an embedded profile where there is one. Memory grows with the rows
// that decode, so that a corrupt header cannot ask for more than the file can fill.
#include <png.h>

#include <bit>
#include <cstdio>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "image/color_space.hpp"
#include "image/formats.hpp"
#include "image/icc.hpp"
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

    Picture readPixels();
    Metadata texts() const;

private:
    std::optional<IccDecoder> embeddedProfile() const;

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

// The value of every code of 8 or 16 bits: 0..1, by the curve.
std::vector<float> valuesOfCodes(int bits, TransferCurve curve) {
    std::vector<float> values(std::size_t{1} << static_cast<unsigned>(bits));
    const auto maxCode = static_cast<double>(values.size() - 1);
    for (std::size_t code = 0; code < values.size(); ++code)
        values[code] = static_cast<float>(curve(static_cast<double>(code) / maxCode));
    return values;
}

template <class Code>
void look(const std::vector<Code>& codes, const std::vector<float>& values, std::vector<float>& rgb) {
    for (std::size_t i = 0; i < codes.size(); ++i) rgb[i] = values[codes[i]];
}

std::optional<IccDecoder> Decoder::embeddedProfile() const {
    png_charp name = nullptr;
    int compression = 0;
    png_bytep bytes = nullptr;
    png_uint_32 size = 0;
    if (png_get_iCCP(handle_.png, handle_.info, &name, &compression, &bytes, &size) == 0) return {};
    return IccDecoder::create({bytes, size});
}

Picture Decoder::readPixels() {
    const png_structp png = handle_.png;
    const png_infop info = handle_.info;
    Picture image{png_get_image_width(png, info), png_get_image_height(png, info), Quantity::color, {}};
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

    const std::optional<IccDecoder> profile = embeddedProfile();
    const auto asItIs = [](double encoded) { return encoded; };
    const std::vector<float> values = valuesOfCodes(isDeep ? 16 : 8, profile ? asItIs : decodeSrgb);
    std::vector<float> rgb(std::size_t{3} * image.width);
    std::vector<std::uint8_t> row8(isDeep ? 0 : std::size_t{3} * image.width);
    std::vector<std::uint16_t> row16(isDeep ? std::size_t{3} * image.width : 0);
    const auto row = isDeep ? reinterpret_cast<png_bytep>(row16.data()) : row8.data();
    for (std::uint32_t y = 0; y < image.height; ++y) {
        require([&] { png_read_row(png, row, nullptr); });
        isDeep ? look(row16, values, rgb) : look(row8, values, rgb);
        if (profile) profile->decode(rgb);
        for (std::size_t i = 0; i < rgb.size(); i += 3)
            image.pixels.push_back({rgb[i], rgb[i + 1], rgb[i + 2], false});
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

Picture readPng(std::FILE* stream, const std::filesystem::path& path) {
    return Decoder(stream, path).readPixels();
}

Metadata readPngMetadata(std::FILE* stream, const std::filesystem::path& path) {
    return Decoder(stream, path).texts();
}

}  // namespace fringe::image
