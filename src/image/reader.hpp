// Files to pictures. The content decides the format, not the name.
#pragma once

#include <filesystem>

#include "image/file_error.hpp"
#include "image/image.hpp"

namespace fringe::image {

// The largest side of a picture that is read, in pixels; what claims more is taken for corrupt.
inline constexpr std::uint32_t kMaxReadSide = 65536;

// The picture as linear sRGB.
// PNG: any colour type and depth, not interlaced; taken as sRGB encoded, alpha is ignored.
// EXR: R, G and B at full resolution in any pixel type, taken as linear sRGB; a channel "nonfinite"
//      above 0 marks the pixel; other channels are ignored.
// Throws FileError when the file cannot be read, is truncated or corrupt, or holds another layout.
Image readImage(const std::filesystem::path& path);

// The texts in a file: the text chunks before the pixels (PNG, in their order) or the string
// attributes (EXR, which keeps them sorted by key). Throws FileError.
Metadata readMetadata(const std::filesystem::path& path);

}  // namespace fringe::image
