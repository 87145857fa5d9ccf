#include "image/reader.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "image/formats.hpp"

namespace fringe::image {

namespace {

using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string cannotBeRead(int error) {
    return "cannot be read: " + std::generic_category().message(error);
}

Stream openForReading(const std::filesystem::path& path) {
    Stream stream(std::fopen(path.c_str(), "rbe"), &std::fclose);
    if (!stream) throw FileError(path, cannotBeRead(errno));
    return stream;
}

// The format that the first bytes name; leaves the stream at its start.
Format formatOf(std::FILE* stream, const std::filesystem::path& path) {
    using namespace std::string_view_literals;
    std::array<char, 8> bytes{};
    const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), stream);
    if (std::ferror(stream) != 0 || std::fseek(stream, 0, SEEK_SET) != 0)
        throw FileError(path, cannotBeRead(errno));
    const std::string_view start(bytes.data(), size);
    if (start == "\x89PNG\r\n\x1A\n"sv) return Format::png;
    if (start.substr(0, 4) == "\x76\x2F\x31\x01"sv) return Format::exr;
    throw FileError(path, "is neither a PNG nor an EXR file");
}

}  // namespace

void requireReadableSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height) {
    if (width < 1 || height < 1 || width > kMaxReadSide || height > kMaxReadSide)
        throw FileError(path, "claims " + std::to_string(width) + "x" + std::to_string(height) +
                                  " pixels; a side has 1 to " + std::to_string(kMaxReadSide));
}

Picture readImage(const std::filesystem::path& path) {
    const Stream stream = openForReading(path);
    const bool isPng = formatOf(stream.get(), path) == Format::png;
    return isPng ? readPng(stream.get(), path) : readExr(stream.get(), path);
}

Metadata readMetadata(const std::filesystem::path& path) {
    const Stream stream = openForReading(path);
    const bool isPng = formatOf(stream.get(), path) == Format::png;
    return isPng ? readPngMetadata(stream.get(), path) : readExrMetadata(stream.get(), path);
}

}  // namespace fringe::image
