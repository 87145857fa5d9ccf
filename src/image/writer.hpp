// Pictures to files, a band of rows at a time, so that a picture larger than memory can be written.
// A file appears whole or not at all: it grows under a temporary name in the folder of its target
// and takes the target's name in finish(). Memory is bounded by a few rows, whatever the height.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "image/develop.hpp"
#include "image/file_error.hpp"
#include "image/image.hpp"

namespace fringe::image {

// The channels of a colour in an EXR file.
enum class ExrColor {
    rgb,  // linear in the primaries of Rec. 709, stated by the attribute `chromaticities`
    xyz   // the film as it is
};

struct OutputOptions {
    Development development = {};         // PNG only, EXR holds linear values under the light of the scene
    int pngBits = 8;                      // 8 or 16
    Quantity quantity = Quantity::color;  // EXR only, unless it is a colour: one channel, named after it
    ExrColor exrColor = ExrColor::rgb;
    double whiteLuminance = 0.0;    // cd/m^2 of Y = 1, > 0 for luminance; EXR states it where it is known
    bool exrFloat = false;          // 32 bit float channels instead of 16 bit half
    bool nonFiniteChannel = false;  // EXR only: a half channel "nonfinite", 1 where the pixel is marked
    Metadata metadata = {};         // keys: see isMetadataKey; values: UTF-8 without NUL
};

// True for a key that both formats can hold: 1 to 79 printable ASCII characters, no space at either end or
// beside another (as PNG asks of a keyword), and none of the header names that OpenEXR gives a meaning.
bool isMetadataKey(const std::string& key);

class Writer {
public:
    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    virtual ~Writer() = default;  // without finish() the temporary file goes and the target stays as it was

    // Append whole rows, the next ones from the top: a multiple of the width. Throws FileError with the
    // system's reason (disk full, ...), after which the writer can only be destroyed.
    virtual void writeRows(std::span<const Pixel> rows) = 0;

    // Complete the file and give it its name, once all rows are written. Throws FileError.
    virtual void finish() = 0;
};

// A writer for the format that the extension names, .png or .exr in any case. An existing file is
// replaced by finish(), a symbolic link is followed. Throws FileError when the extension is another, or is
// .png and the quantity no colour, the folder is missing or not writable, or the target is anything but a
// regular file.
std::unique_ptr<Writer> openWriter(const std::filesystem::path& path, std::uint32_t width,
                                   std::uint32_t height, const OutputOptions& options);

// Throws the FileError that openWriter would throw for this path, and leaves nothing behind.
void requireWritable(const std::filesystem::path& path);

// openWriter, writeRows and finish for a picture that is in memory.
void writeImage(const std::filesystem::path& path, const Image& image, const OutputOptions& options);

}  // namespace fringe::image
