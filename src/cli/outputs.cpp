#include "cli/outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "image/file_error.hpp"

namespace fringe::cli {

Outputs::Outputs(const std::vector<std::string>& paths, std::uint32_t width, std::uint32_t height,
                 const image::OutputOptions& options)
    : width_(width), rowsLeft_(height) {
    for (const std::string& path : paths)
        outputs_.push_back({path, image::openWriter(path, width, height, options)});
}

// Runs `work` on every writer that has not failed yet.
template <class Work>
void Outputs::onEach(Work work) {
    for (Output& output : outputs_) {
        if (!output.writer) continue;
        try {
            work(*output.writer);
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
    onEach([&](image::Writer& writer) { writer.writeRows(rows); });
    rowsLeft_ -= static_cast<std::uint32_t>(rows.size() / width_);
}

void Outputs::fill() {
    const std::vector<image::Pixel> row(width_);
    while (rowsLeft_ > 0) writeRows(row);
}

void Outputs::finish() {
    onEach([](image::Writer& writer) { writer.finish(); });
}

std::vector<std::string> Outputs::written() const {
    std::vector<std::string> paths;
    for (const Output& output : outputs_) {
        if (output.writer) paths.push_back(output.path);
    }
    return paths;
}

}  // namespace fringe::cli
