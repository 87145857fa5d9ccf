// Through libpng's simplified interface, which unpacks every kind of PNG and reports errors without longjmp.
#include "image/luminance_reader.hpp"

#include <png.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <string>

#include "image/develop.hpp"

namespace fringe::image {

LuminancePicture readLuminance(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rb"), std::fclose);
    if (stream == nullptr) throw FileError(path, std::string("cannot be read: ") + std::strerror(errno));

    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const auto require = [&](int success) {
        if (success != 0) return;
        const std::string message = png.message;
        png_image_free(&png);
        throw FileError(path, "is no PNG file, or is truncated or corrupt: " + message);
    };
    require(png_image_begin_read_from_stdio(&png, stream.get()));
    if (png.width > kMaxLuminanceSide || png.height > kMaxLuminanceSide) {
        const std::string size = std::to_string(png.width) + " x " + std::to_string(png.height);
        const std::string largest = std::to_string(kMaxLuminanceSide);
        png_image_free(&png);
        throw FileError(path, "has " + size + " pixels; write at most " + largest + " x " + largest);
    }
    // Of 8 bits the codes come as they are; libpng's own luminance of them would have 8 bits too.
    const std::size_t count = std::size_t{png.width} * png.height;
    LuminancePicture picture{png.width, png.height, {}};
    picture.values.reserve(count);
    if ((png.format & PNG_FORMAT_FLAG_LINEAR) != 0) {
        png.format = PNG_FORMAT_LINEAR_Y;
        png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
        std::vector<std::uint16_t> codes(count);
        require(png_image_finish_read(&png, nullptr, codes.data(), 0, nullptr));
        for (const std::uint16_t code : codes) picture.values.push_back(static_cast<float>(code) / 65535.0F);
        return picture;
    }
    png.format = PNG_FORMAT_RGB;
    const png_color black{0, 0, 0};
    std::vector<std::uint8_t> rgb(3 * count);
    require(png_image_finish_read(&png, &black, rgb.data(), 0, nullptr));
    std::array<double, 256> linear{};
    for (std::size_t code = 0; code < linear.size(); ++code)
        linear[code] = decodeSrgb(static_cast<double>(code) / 255.0);
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        // IEC 61966-2-1, the weights of luminance of its primaries.
        const double y = 0.2126 * linear[rgb[i]] + 0.7152 * linear[rgb[i + 1]] + 0.0722 * linear[rgb[i + 2]];
        picture.values.push_back(static_cast<float>(y));
    }
    return picture;
}

}  // namespace fringe::image
