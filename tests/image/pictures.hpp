// What the tests of the image library share: a folder that goes away, and a picture that exercises the range.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "image/color_space.hpp"
#include "image/image.hpp"

namespace fringe::image {

// A new empty folder for the life of a test.
class TestFolder {
public:
    TestFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "fringe-image-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder " + name);
        path_ = name;
    }
    ~TestFolder() { std::filesystem::remove_all(path_); }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::size_t fileCount() const {
        const auto count = std::distance(std::filesystem::directory_iterator(path_), {});
        return static_cast<std::size_t>(count);
    }

private:
    std::filesystem::path path_;
};

inline std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void putBytes(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::remove(path);  // ext4 waits for the disk when a file is overwritten in place
    std::ofstream(path, std::ios::binary) << bytes;
}

// A pixel of the film from linear sRGB, in double precision and then rounded.
inline Pixel filmOf(const glm::dvec3& rgb) {
    static const glm::dmat3 xyzFromRgb = xyzFromLinear(ColorSpace::srgb);
    const glm::vec3 xyz = xyzFromRgb * rgb;
    return {xyz.x, xyz.y, xyz.z, false};
}

inline Image filmOf(const Picture& picture) {
    Image image{picture.width, picture.height, {}};
    for (const RgbPixel& p : picture.pixels) image.pixels.push_back(filmOf(glm::dvec3(p.r, p.g, p.b)));
    return image;
}

// In linear sRGB: values from far below the first code to white, with no two rows alike.
inline Picture testColors(std::uint32_t width, std::uint32_t height) {
    Picture picture{width, height, Quantity::color, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
            const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
            picture.pixels.push_back(
                {u, std::exp2(-16.0F * v), 0.5F + 0.5F * std::sin(40.0F * u * v), false});
        }
    return picture;
}

// The same on the film.
inline Image testPicture(std::uint32_t width, std::uint32_t height) {
    return filmOf(testColors(width, height));
}

}  // namespace fringe::image
