// A PNG file as a picture of luminance, for masks: one value a pixel, without the rest of a colour.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "image/file_error.hpp"

namespace fringe::image {

// The largest side of such a picture, in pixels.
inline constexpr std::uint32_t kMaxLuminanceSide = 4096;

struct LuminancePicture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> values;  // width * height, row by row from the top; 0 to 1, linear
};

// Any PNG file, by default taken as sRGB; what is transparent counts as black.
// Throws FileError when the file cannot be read, is truncated or corrupt, or is larger than the largest side.
LuminancePicture readLuminance(const std::filesystem::path& path);

}  // namespace fringe::image
