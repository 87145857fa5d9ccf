// EXR by OpenEXR. Memory grows with the lines that decode, so that a corrupt header cannot ask for more
// than the file can fill.
#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/mat3x3.hpp>
#include <span>
#include <string>
#include <vector>

#include "image/color_space.hpp"
#include "image/formats.hpp"

namespace fringe::image {

namespace {

class FileStream final : public Imf::IStream {
public:
    FileStream(std::FILE* stream, const std::string& name) : IStream(name.c_str()), stream_(stream) {}

    bool read(char bytes[], int size) override {  // false at the end of the file, as IStream asks
        if (std::fread(bytes, 1, static_cast<std::size_t>(size), stream_) != static_cast<std::size_t>(size))
            throw Iex::InputExc("the file ends too early");
        const int next = std::fgetc(stream_);
        if (next != EOF) std::ungetc(next, stream_);
        return next != EOF;
    }
    std::uint64_t tellg() override { return static_cast<std::uint64_t>(::ftello(stream_)); }
    void seekg(std::uint64_t position) override { ::fseeko(stream_, static_cast<off_t>(position), SEEK_SET); }
    void clear() override { std::clearerr(stream_); }

private:
    std::FILE* stream_;
};

// What `read` makes of the file; OpenEXR's complaints about the file become a FileError.
template <class Read>
auto readFile(std::FILE* stream, const std::filesystem::path& path, const Read& read) {
    try {
        FileStream input(stream, path.string());
        Imf::InputFile file(input, /*numThreads=*/0);
        return read(file);
    } catch (const Iex::BaseExc& problem) {
        throw FileError(path, std::string("is truncated or corrupt: ") + problem.what());
    }
}

// What the channels of a file say.
struct Layout {
    std::array<const char*, 3> channels;  // of a pixel; a quantity that is no colour has the first alone
    Quantity quantity;
    bool isXyz;
};

Layout layoutOf(const Imf::ChannelList& channels, const std::filesystem::path& path) {
    const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
    if (has("R") || has("G") || has("B")) {
        for (const char* name : {"R", "G", "B"})
            if (!has(name))
                throw FileError(path, std::string("has no channel ") + name + " beside the others");
        return {{"R", "G", "B"}, Quantity::color, false};
    }
    if (has("X") && has("Y") && has("Z")) return {{"X", "Y", "Z"}, Quantity::color, true};
    for (const Quantity quantity : {Quantity::luminance, Quantity::radiance, Quantity::irradiance}) {
        const char* name = nameOf(quantity);
        if (has(name)) return {{name, "", ""}, quantity, false};
    }
    throw FileError(path,
                    "has none of the channels that are read: R, G and B; X, Y and Z; luminance, radiance "
                    "or irradiance");
}

void requireFullResolution(const Imf::ChannelList& channels, const Layout& layout,
                           const std::filesystem::path& path) {
    const auto require = [&](const char* name) {
        const Imf::Channel* channel = channels.findChannel(name);
        if (channel != nullptr && (channel->xSampling != 1 || channel->ySampling != 1))
            throw FileError(path, std::string("has channel ") + name + " at less than full resolution");
    };
    for (const char* name : layout.channels) require(name);
    require("nonfinite");
}

void toRgb(std::span<RgbPixel> xyz) {
    const glm::dmat3 rgbFromXyz = linearFromXyz(ColorSpace::srgb);
    for (RgbPixel& pixel : xyz) {
        const glm::vec3 rgb = rgbFromXyz * glm::dvec3(pixel.r, pixel.g, pixel.b);
        pixel = {rgb.x, rgb.y, rgb.z, pixel.nonFinite};
    }
}

Picture readPixels(Imf::InputFile& file, const std::filesystem::path& path) {
    const Imf::ChannelList& channels = file.header().channels();
    const Layout layout = layoutOf(channels, path);
    requireFullResolution(channels, layout, path);
    const Imath::Box2i window = file.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    requireReadableSize(path, width, height);

    Picture picture{
        static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), layout.quantity, {}};
    std::vector<float> marks;
    for (std::int64_t y = 0; y < height; y += kExrBandRows) {
        const std::int64_t rows = std::min<std::int64_t>(kExrBandRows, height - y);
        const std::size_t done = picture.pixels.size();
        picture.pixels.resize(done + static_cast<std::size_t>(width * rows));
        marks.assign(static_cast<std::size_t>(width * rows), 0.0F);

        // OpenEXR converts any pixel type to float and fills a channel that the file lacks with 0.
        const Imath::V2i origin(window.min.x, static_cast<int>(window.min.y + y));
        RgbPixel* const band = picture.pixels.data() + done;
        Imf::FrameBuffer frame;
        const auto insert = [&](const char* channel, float* first, std::size_t stride) {
            frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, first, origin, width, rows, stride,
                                                   stride * picture.width));
        };
        insert(layout.channels[0], &band->r, sizeof(RgbPixel));
        if (layout.quantity == Quantity::color) {
            insert(layout.channels[1], &band->g, sizeof(RgbPixel));
            insert(layout.channels[2], &band->b, sizeof(RgbPixel));
        }
        insert("nonfinite", marks.data(), sizeof(float));
        file.setFrameBuffer(frame);
        file.readPixels(origin.y, static_cast<int>(origin.y + rows - 1));
        for (std::size_t i = 0; i < marks.size(); ++i) {
            band[i].nonFinite = marks[i] > 0.0F;
            if (layout.quantity != Quantity::color) band[i].g = band[i].b = band[i].r;
        }
    }
    if (layout.isXyz) toRgb(picture.pixels);
    return picture;
}

}  // namespace

Picture readExr(std::FILE* stream, const std::filesystem::path& path) {
    return readFile(stream, path, [&](Imf::InputFile& file) { return readPixels(file, path); });
}

Metadata readExrMetadata(std::FILE* stream, const std::filesystem::path& path) {
    return readFile(stream, path, [](const Imf::InputFile& file) {
        Metadata metadata;
        for (auto at = file.header().begin(); at != file.header().end(); ++at)
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&at.attribute()))
                metadata.emplace_back(at.name(), text->value());
        return metadata;
    });
}

}  // namespace fringe::image
