#include "image/writer.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <string>
#include <string_view>

#include "image/formats.hpp"
#include "image/pending_file.hpp"

namespace fringe::image {
namespace {

Format formatOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") return Format::png;
    if (extension == ".exr") return Format::exr;
    throw FileError(path, "the name does not say which format to write; end it in .png or .exr");
}

}  // namespace

bool isMetadataKey(const std::string& key) {
    // Header attributes that readers of EXR files expect to hold their own type.
    static constexpr std::array<std::string_view, 17> taken = {"channels",
                                                               "chromaticities",
                                                               "chunkCount",
                                                               "compression",
                                                               "dataWindow",
                                                               "displayWindow",
                                                               "lineOrder",
                                                               "name",
                                                               "pixelAspectRatio",
                                                               "screenWindowCenter",
                                                               "screenWindowWidth",
                                                               "tiles",
                                                               "type",
                                                               "unit",
                                                               "version",
                                                               "view",
                                                               "whiteLuminance"};
    const auto isPrintable = [](char c) { return c >= ' ' && c <= '~'; };
    return !key.empty() && key.size() <= 79 && std::all_of(key.begin(), key.end(), isPrintable) &&
           key.front() != ' ' && key.back() != ' ' && key.find("  ") == std::string::npos &&
           std::find(taken.begin(), taken.end(), key) == taken.end();
}

std::unique_ptr<Writer> openWriter(const std::filesystem::path& path, std::uint32_t width,
                                   std::uint32_t height, const OutputOptions& options) {
    assert(width > 0 && height > 0);
    assert(options.pngBits == 8 || options.pngBits == 16);
    assert(options.quantity != Quantity::luminance || options.whiteLuminance > 0.0);
    assert(std::all_of(options.metadata.begin(), options.metadata.end(), [](const auto& entry) {
        return isMetadataKey(entry.first) && entry.second.find('\0') == std::string::npos;
    }));

    const Format format = formatOf(path);
    if (format == Format::png && options.quantity != Quantity::color)
        throw FileError(path, std::string("a PNG file holds colours only; give ") + nameOf(options.quantity) +
                                  " a name that ends in .exr");
    return format == Format::png ? openPngWriter(path, width, height, options)
                                 : openExrWriter(path, width, height, options);
}

void requireWritable(const std::filesystem::path& path) {
    formatOf(path);
    const PendingFile probe(path);
}

void writeImage(const std::filesystem::path& path, const Image& image, const OutputOptions& options) {
    const std::unique_ptr<Writer> writer = openWriter(path, image.width, image.height, options);
    writer->writeRows(image.pixels);
    writer->finish();
}

}  // namespace fringe::image
