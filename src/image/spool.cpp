#include "image/spool.hpp"

#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace fringe::image {

namespace {

constexpr std::size_t kRowsAtOnce = 64;

[[noreturn]] void fail(const std::filesystem::path& folder) {
    throw FileError(folder, "cannot hold the picture until its exposure is known: " +
                                std::generic_category().message(errno));
}

}  // namespace

Spool::Spool(std::uint32_t width, std::size_t memory)
    : width_(width), memory_(memory), file_(nullptr, &std::fclose) {}

void Spool::append(std::span<const Pixel> rows) {
    assert(rows.size() % width_ == 0);
    if (inMemory_ + rows.size_bytes() > memory_) moveToFile();
    kept_.emplace_back(rows.begin(), rows.end());
    inMemory_ += rows.size_bytes();
}

void Spool::openFile() {
    const char* given = std::getenv("TMPDIR");  // std::filesystem::temp_directory_path() refuses a wrong one
    folder_ = given != nullptr && *given != '\0' ? given : "/tmp";
    std::string name = (folder_ / "fringe-XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) fail(folder_);
    ::unlink(name.c_str());
    file_.reset(::fdopen(descriptor, "w+b"));
    if (!file_) {
        ::close(descriptor);
        fail(folder_);
    }
}

void Spool::moveToFile() {
    if (!file_) openFile();
    for (const std::vector<Pixel>& rows : kept_) {
        if (std::fwrite(rows.data(), sizeof(Pixel), rows.size(), file_.get()) != rows.size()) fail(folder_);
        inFile_ += rows.size() / width_;
    }
    if (std::fflush(file_.get()) != 0) fail(folder_);
    kept_.clear();
    inMemory_ = 0;
}

void Spool::replay(const std::function<void(std::span<const Pixel>)>& sink) const {
    if (file_) std::rewind(file_.get());
    std::vector<Pixel> buffer(std::min(inFile_, kRowsAtOnce) * width_);
    for (std::size_t row = 0; row < inFile_; row += kRowsAtOnce) {
        const auto rows = std::span(buffer).first(std::min(kRowsAtOnce, inFile_ - row) * width_);
        if (std::fread(rows.data(), sizeof(Pixel), rows.size(), file_.get()) != rows.size()) fail(folder_);
        sink(rows);
    }
    for (const std::vector<Pixel>& rows : kept_) sink(rows);
}

}  // namespace fringe::image
