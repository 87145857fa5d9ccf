#include "cli/outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "image/file_error.hpp"

namespace fringe::cli {

namespace {

// A full disk under the spool ends the render as one under the pictures does.
template <class Work>
void withSpool(Work work) {
    try {
        work();
    } catch (const image::FileError& error) {
        throw NothingWritten(error.what());
    }
}

}  // namespace

Outputs::Outputs(const std::vector<std::string>& paths, const scene::Image& image, OptionsAt optionsAt)
    : width_(image.width),
      height_(image.height),
      rowsLeft_(image.height),
      exposure_(image.exposure),
      optionsAt_(std::move(optionsAt)) {
    for (const std::string& path : paths) outputs_.push_back({path, open(path)});
    if (image.autoExposure)
        undeveloped_.emplace(
            Undeveloped{image::ExposureMeter(optionsAt_(exposure_).development), image::Spool(image.width)});
}

std::unique_ptr<image::Writer> Outputs::open(const std::string& path) const {
    return image::openWriter(path, width_, height_, optionsAt_(exposure_));
}

// Runs `work` on every output that has not failed yet.
template <class Work>
void Outputs::onEach(Work work) {
    for (Output& output : outputs_) {
        if (!output.writer) continue;
        try {
            work(output);
        } catch (const image::FileError& error) {
            failures_.emplace_back(error.what());
            output.writer.reset();
        }
    }
    if (failures_.size() == outputs_.size()) {
        throw NothingWritten(fmt::format("{}", fmt::join(failures_, "\nfringe: ")));
    }
}

void Outputs::writeRows(std::span<const image::Pixel> rows) {
    if (undeveloped_) {
        undeveloped_->meter.add(rows);
        withSpool([&] { undeveloped_->spool.append(rows); });
    } else {
        onEach([&](Output& output) { output.writer->writeRows(rows); });
    }
    rowsLeft_ -= static_cast<std::uint32_t>(rows.size() / width_);
}

void Outputs::fill() {
    const std::vector<image::Pixel> row(width_);
    while (rowsLeft_ > 0) writeRows(row);
}

// The files are begun anew, since their headers state the exposure.
void Outputs::developAll() {
    exposure_ += undeveloped_->meter.exposure();
    onEach([&](Output& output) { output.writer = open(output.path); });
    withSpool([&] {
        undeveloped_->spool.replay([&](std::span<const image::Pixel> rows) {
            onEach([&](Output& output) { output.writer->writeRows(rows); });
        });
    });
    undeveloped_.reset();
}

void Outputs::finish() {
    if (undeveloped_) developAll();
    onEach([](Output& output) { output.writer->finish(); });
}

std::vector<std::string> Outputs::written() const {
    std::vector<std::string> paths;
    for (const Output& output : outputs_) {
        if (output.writer) paths.push_back(output.path);
    }
    return paths;
}

}  // namespace fringe::cli
