// EXR by OpenEXR: scan lines of R, G, B (and nonfinite) as half or float, linear, in the sRGB primaries.
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
#include <optional>
#include <string>
#include <vector>

#include "image/formats.hpp"
#include "image/pending_file.hpp"

namespace fringe::image {

namespace {

constexpr std::uint32_t kBandRows = 16;  // the rows that ZIP compression takes together

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

Imf::Header headerOf(std::uint32_t width, std::uint32_t height, const OutputOptions& options) {
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    // Measured on renders of 600x600: level 1 halves the time of the default and costs a tenth to a quarter
    // in size. The mantissas of floats hardly compress: ZIP would save a tenth in four times the time, while
    // run lengths still take the empty parts of a picture.
    header.compression() = options.exrFloat ? Imf::RLE_COMPRESSION : Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 1;
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709 with D65: sRGB's
    for (const char* channel : {"R", "G", "B"})
        header.channels().insert(channel, Imf::Channel(options.exrFloat ? Imf::FLOAT : Imf::HALF));
    if (options.nonFiniteChannel) header.channels().insert("nonfinite", Imf::Channel(Imf::HALF));
    for (const auto& [key, value] : options.metadata) header.insert(key, Imf::StringAttribute(value));
    return header;
}

// The nearest half; what is too large becomes the largest one, since an infinity would spread through
// any later filter. A NaN stays one.
half toHalf(float value) {
    return half(std::clamp(value, -float{HALF_MAX}, float{HALF_MAX}));
}

struct HalfPixel {
    half r, g, b, nonFinite;
};

class ExrWriter final : public Writer {
public:
    ExrWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              const OutputOptions& options);

    void writeRows(std::span<const Pixel> rows) override;
    void finish() override;

private:
    void writeBand(std::span<const Pixel> band);

    PendingFile file_;
    PendingStream stream_;                   // writes to file_
    std::optional<Imf::OutputFile> output_;  // writes to stream_
    std::uint32_t width_;
    std::uint32_t rowsLeft_;
    bool exrFloat_;
    std::vector<HalfPixel> halves_;  // one band
};

ExrWriter::ExrWriter(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                     const OutputOptions& options)
    : file_(path),
      stream_(file_, path.string()),
      output_(std::in_place, stream_, headerOf(width, height, options), /*numThreads=*/0),
      width_(width),
      rowsLeft_(height),
      exrFloat_(options.exrFloat) {}

void ExrWriter::writeRows(std::span<const Pixel> rows) {
    assert(rows.size() % width_ == 0 && rows.size() / width_ <= rowsLeft_);
    const std::size_t bandSize = std::size_t{kBandRows} * width_;
    for (; !rows.empty(); rows = rows.subspan(std::min(bandSize, rows.size())))
        writeBand(rows.first(std::min(bandSize, rows.size())));
}

void ExrWriter::writeBand(std::span<const Pixel> band) {
    halves_.clear();
    for (const Pixel& pixel : band)
        halves_.push_back(
            {toHalf(pixel.r), toHalf(pixel.g), toHalf(pixel.b), half(pixel.nonFinite ? 1.0F : 0.0F)});

    // OpenEXR picks the channels of the file by name; floats are taken from the pixels where they stand.
    const auto rowCount = static_cast<std::uint32_t>(band.size() / width_);
    Imf::FrameBuffer frame;
    const auto insert = [&](const char* channel, Imf::PixelType type, const void* first, std::size_t stride) {
        const Imath::V2i origin(0, output_->currentScanLine());
        frame.insert(channel,
                     Imf::Slice::Make(type, first, origin, width_, rowCount, stride, stride * width_));
    };
    if (exrFloat_) {
        insert("R", Imf::FLOAT, &band.front().r, sizeof(Pixel));
        insert("G", Imf::FLOAT, &band.front().g, sizeof(Pixel));
        insert("B", Imf::FLOAT, &band.front().b, sizeof(Pixel));
    } else {
        insert("R", Imf::HALF, &halves_.front().r, sizeof(HalfPixel));
        insert("G", Imf::HALF, &halves_.front().g, sizeof(HalfPixel));
        insert("B", Imf::HALF, &halves_.front().b, sizeof(HalfPixel));
    }
    insert("nonfinite", Imf::HALF, &halves_.front().nonFinite, sizeof(HalfPixel));

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
