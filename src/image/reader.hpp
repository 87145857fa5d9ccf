// Files to pictures. The content decides the format, not the name.
#pragma once

#include <filesystem>

#include "image/file_error.hpp"
#include "image/image.hpp"

namespace fringe::image {

// The largest side of a picture that is read, in pixels; what claims more is taken for corrupt.
inline constexpr std::uint32_t kMaxReadSide = 65536;

// The picture as linear sRGB, or as the one quantity that it holds.
// PNG: any colour type and depth, not interlaced; an ICC profile of an RGB device is obeyed, and may give
//      values below 0 and above 1; else taken as sRGB encoded. Alpha is ignored.
// EXR: at full resolution in any pixel type: R, G and B, taken as linear sRGB; X, Y and Z; luminance,
//      radiance or irradiance. A channel "nonfinite" above 0 marks the pixel; other channels are ignored.
// Throws FileError when the file cannot be read, is truncated or corrupt, or holds another layout.
Picture readImage(const std::filesystem::path& path);

// The texts in a file: the text chunks before the pixels (PNG, in their order) or the string
// attributes (EXR, which keeps them sorted by key). Throws FileError.
Metadata readMetadata(const std::filesystem::path& path);

}  // namespace fringe::image
