// The files of one render: all get the same rows, and the failure of one does not lose the others.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "image/writer.hpp"

namespace fringe::cli {

class Outputs {
public:
    // Opens every file, so that a wrong path is known before the work. Throws image::FileError.
    Outputs(const std::vector<std::string>& paths, std::uint32_t width, std::uint32_t height,
            const image::OutputOptions& options);

    void writeRows(std::span<const image::Pixel> rows);

    // Rows of black until the picture is complete.
    void fill();

    void finish();

    // Messages of the files that failed; they have left nothing behind.
    const std::vector<std::string>& failures() const { return failures_; }

private:
    template <class Work>
    void onEach(Work work);

    std::vector<std::unique_ptr<image::Writer>> writers_;
    std::vector<std::string> failures_;
    std::uint32_t width_;
    std::uint32_t rowsLeft_;
};

}  // namespace fringe::cli
