// The files of one render: all get the same rows, and the failure of one does not lose the others.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/writer.hpp"

namespace fringe::cli {

// Every file has failed, so going on is pointless; the message has one line for each.
class NothingWritten : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Outputs {
public:
    // Opens every file, so that a wrong path is known before the work. Throws image::FileError.
    Outputs(const std::vector<std::string>& paths, std::uint32_t width, std::uint32_t height,
            const image::OutputOptions& options);

    // These three throw NothingWritten.
    void writeRows(std::span<const image::Pixel> rows);
    void fill();  // rows of black until the picture is complete
    void finish();

    // Messages of the files that failed; they have left nothing behind.
    const std::vector<std::string>& failures() const { return failures_; }

    // The files that have not failed.
    std::vector<std::string> written() const;

private:
    struct Output {
        std::string path;
        std::unique_ptr<image::Writer> writer;  // null after a failure
    };

    template <class Work>
    void onEach(Work work);

    std::vector<Output> outputs_;
    std::vector<std::string> failures_;
    std::uint32_t width_;
    std::uint32_t rowsLeft_;
};

}  // namespace fringe::cli
