// The file formats behind openWriter, readImage and readMetadata. Internal to the image library.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "image/image.hpp"
#include "image/writer.hpp"

namespace fringe::image {

enum class Format { png, exr };

// The rows of an EXR file that ZIP compression takes together.
inline constexpr std::uint32_t kExrBandRows = 16;

std::unique_ptr<Writer> openPngWriter(const std::filesystem::path& path, std::uint32_t width,
                                      std::uint32_t height, const OutputOptions& options);
std::unique_ptr<Writer> openExrWriter(const std::filesystem::path& path, std::uint32_t width,
                                      std::uint32_t height, const OutputOptions& options);

// The readers take the stream at its start; path is for messages. They throw FileError.
Picture readPng(std::FILE* stream, const std::filesystem::path& path);
Picture readExr(std::FILE* stream, const std::filesystem::path& path);
Metadata readPngMetadata(std::FILE* stream, const std::filesystem::path& path);
Metadata readExrMetadata(std::FILE* stream, const std::filesystem::path& path);

// Throws FileError for a picture without pixels or with a side beyond kMaxReadSide.
void requireReadableSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height);

}  // namespace fringe::image
