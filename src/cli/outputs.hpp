// The files of one render: all get the same rows, and the failure of one does not lose the others.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "image/exposure_meter.hpp"
#include "image/spool.hpp"
#include "image/writer.hpp"
#include "scene/scene.hpp"

namespace fringe::cli {

// Every file has failed, so going on is pointless; the message has one line for each.
class NothingWritten : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Outputs {
public:
    // How to write at an exposure, in stops. With automatic exposure it is asked again when that is known.
    using OptionsAt = std::function<image::OutputOptions(double exposure)>;

    // Opens every file, so that a wrong path is known before the work. With automatic exposure all rows wait
    // in a spool for finish(). Throws image::FileError.
    Outputs(const std::vector<std::string>& paths, const scene::Image& image, OptionsAt optionsAt);

    // These three throw NothingWritten.
    void writeRows(std::span<const image::Pixel> rows);
    void fill();  // rows of black until the picture is complete
    void finish();

    // Messages of the files that failed; they have left nothing behind.
    const std::vector<std::string>& failures() const { return failures_; }

    // The files that have not failed.
    std::vector<std::string> written() const;

    // Stops; where automatic, what finish() has found, with the scene's own number added.
    double exposure() const { return exposure_; }

private:
    struct Output {
        std::string path;
        std::unique_ptr<image::Writer> writer;  // null after a failure
    };

    // The picture whose exposure is yet to be known.
    struct Undeveloped {
        image::ExposureMeter meter;
        image::Spool spool;
    };

    template <class Work>
    void onEach(Work work);
    std::unique_ptr<image::Writer> open(const std::string& path) const;
    void developAll();

    std::uint32_t width_;
    std::uint32_t height_;
    std::uint32_t rowsLeft_;
    double exposure_;
    OptionsAt optionsAt_;
    std::vector<Output> outputs_;
    std::vector<std::string> failures_;
    std::optional<Undeveloped> undeveloped_;
};

}  // namespace fringe::cli
