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

// Values from far below the first code to a little beyond white, with no two rows alike.
inline Image testPicture(std::uint32_t width, std::uint32_t height) {
    Image image{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
            const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
            image.pixels.push_back(
                {1.2F * u, std::exp2(-16.0F * v), 0.5F + 0.5F * std::sin(40.0F * u * v), false});
        }
    return image;
}

}  // namespace fringe::image
