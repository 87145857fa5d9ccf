// EXR by OpenEXR: scan lines of half or float channels (and nonfinite): R, G, B in the sRGB primaries; X, Y,
// Z; or one quantity, named and with its unit. All linear.
#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <cassert>
#include <glm/mat3x3.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "image/formats.hpp"
#include "image/pending_file.hpp"

namespace fringe::image {

namespace {

class PendingStream final : public Imf::OStream {
public:
    PendingStream(PendingFile& file, const std::string& name) : OStream(name.c_str()), file_(file) {}

    void write(const char bytes[], int size) override {
        if (!file_.write(bytes, static_cast<std::size_t>(size))) file_.fail({});
    }
    std::uint64_t tellp() override { return file_.tell(); }
    void seekp(std::uint64_t position) override {
        if (!file_.seek(position)) file_.fail({});
    }

private:
    PendingFile& file_;
};

std::vector<const char*> channelsOf(const OutputOptions& options) {
    if (options.quantity != Quantity::color) return {nameOf(options.quantity)};
    if (options.exrColor == ExrColor::xyz) return {"X", "Y", "Z"};
    return {"R", "G", "B"};
}

Imf::Header headerOf(std::uint32_t width, std::uint32_t height, const OutputOptions& options) {
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    // Measured on renders of 600x600: level 1 halves the time of the default and costs a tenth to a quarter
    // in size. The mantissas of floats hardly compress: ZIP would save a tenth in four times the time, while
    // run lengths still take the empty parts of a picture.
    header.compression() = options.exrFloat ? Imf::RLE_COMPRESSION : Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;
    for (const char* channel : channelsOf(options))
        header.channels().insert(channel, Imf::Channel(options.exrFloat ? Imf::FLOAT : Imf::HALF));
    if (options.quantity == Quantity::color) {
        // The default is Rec. 709 with D65: sRGB's.
        if (options.exrColor == ExrColor::rgb) Imf::addChromaticities(header, Imf::Chromaticities());
        if (options.whiteLuminance > 0.0)
            Imf::addWhiteLuminance(header, static_cast<float>(options.whiteLuminance));
    } else {
        header.insert("unit", Imf::StringAttribute(unitOf(options.quantity)));
    }
    if (options.nonFiniteChannel) header.channels().insert("nonfinite", Imf::Channel(Imf::HALF));
    for (const auto& [key, value] : options.metadata) header.insert(key, Imf::StringAttribute(value));
    return header;
}

// The nearest half; what is too large becomes the largest one, since an infinity would spread through
// any later filter. A NaN stays one.
half toHalf(float value) {
    return half(std::clamp(value, -float{HALF_MAX}, float{HALF_MAX}));
}

class ExrWriter final : public Writer {
public:
    ExrWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              const OutputOptions& options);

    void writeRows(std::span<const Pixel> rows) override;
    void finish() override;

private:
    void writeBand(std::span<const Pixel> band);
    void appendValues(const Pixel& pixel);

    PendingFile file_;
    PendingStream stream_;                   // writes to file_
    std::optional<Imf::OutputFile> output_;  // writes to stream_
    std::uint32_t width_;
    std::uint32_t rowsLeft_;
    std::vector<const char*> channels_;
    ExrColor color_;
    float unit_;  // what a quantity's value in y is multiplied by
    bool isFloat_;
    std::vector<float> floats_;  // these three hold one band; pixel by pixel, as many as channels
    std::vector<half> halves_;   // where the file has halves
    std::vector<half> marks_;
};

ExrWriter::ExrWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                     const OutputOptions& options)
    : file_(path),
      stream_(file_, path.string()),
      output_(std::in_place, stream_, headerOf(width, height, options), /*numThreads=*/0),
      width_(width),
      rowsLeft_(height),
      channels_(channelsOf(options)),
      color_(options.exrColor),
      unit_(options.quantity == Quantity::luminance ? static_cast<float>(options.whiteLuminance) : 1.0F),
      isFloat_(options.exrFloat) {}

void ExrWriter::writeRows(std::span<const Pixel> rows) {
    assert(rows.size() % width_ == 0 && rows.size() / width_ <= rowsLeft_);
    const std::size_t bandSize = std::size_t{kExrBandRows} * width_;
    for (; !rows.empty(); rows = rows.subspan(std::min(bandSize, rows.size())))
        writeBand(rows.first(std::min(bandSize, rows.size())));
}

void ExrWriter::appendValues(const Pixel& pixel) {
    if (channels_.size() == 1) {
        floats_.push_back(pixel.y * unit_);
    } else if (color_ == ExrColor::xyz) {
        floats_.insert(floats_.end(), {pixel.x, pixel.y, pixel.z});
    } else {
        static const glm::dmat3 rgbFromXyz = linearFromXyz(ColorSpace::srgb);
        const glm::vec3 rgb = rgbFromXyz * glm::dvec3(pixel.x, pixel.y, pixel.z);
        floats_.insert(floats_.end(), {rgb.x, rgb.y, rgb.z});
    }
}

void ExrWriter::writeBand(std::span<const Pixel> band) {
    floats_.clear();
    marks_.clear();
    for (const Pixel& pixel : band) {
        appendValues(pixel);
        marks_.emplace_back(pixel.nonFinite ? 1.0F : 0.0F);
    }
    halves_.clear();
    if (!isFloat_) std::transform(floats_.begin(), floats_.end(), std::back_inserter(halves_), toHalf);

    // OpenEXR picks the channels of the file by name.
    const auto rowCount = static_cast<std::uint32_t>(band.size() / width_);
    Imf::FrameBuffer frame;
    const auto insert = [&](const char* channel, Imf::PixelType type, const void* first, std::size_t stride) {
        const Imath::V2i origin(0, output_->currentScanLine());
        frame.insert(channel,
                     Imf::Slice::Make(type, first, origin, width_, rowCount, stride, stride * width_));
    };
    for (std::size_t c = 0; c < channels_.size(); ++c) {
        if (isFloat_) insert(channels_[c], Imf::FLOAT, &floats_[c], channels_.size() * sizeof(float));
        else insert(channels_[c], Imf::HALF, &halves_[c], channels_.size() * sizeof(half));
    }
    insert("nonfinite", Imf::HALF, marks_.data(), sizeof(half));

    output_->setFrameBuffer(frame);
    output_->writePixels(static_cast<int>(rowCount));
    rowsLeft_ -= rowCount;
}

void ExrWriter::finish() {
    assert(rowsLeft_ == 0);
    output_.reset();  // writes the table of line offsets; it keeps quiet on failure, commit() does not
    file_.commit();
}

}  // namespace

std::unique_ptr<Writer> openExrWriter(const std::filesystem::path& path, std::uint32_t width,
                                      std::uint32_t height, const OutputOptions& options) {
    return std::make_unique<ExrWriter>(path, width, height, options);
}

}  // namespace fringe::image
