#include "image/pending_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace fringe::image {

namespace fs = std::filesystem;

namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

// The file that a chain of symbolic links ends at, whether it exists or not.
fs::path followLinks(const fs::path& path) {
    constexpr int maxHops = 40;  // as many as Linux follows
    fs::path target = path;
    std::error_code ignored;
    for (int hops = 0; fs::is_symlink(fs::symlink_status(target, ignored)); ++hops) {
        if (hops == maxHops) throw FileError(path, "cannot be written: " + reason(ELOOP));
        target = target.parent_path() / fs::read_symlink(target);  // an absolute link replaces the whole path
    }
    return target;
}

}  // namespace

PendingFile::PendingFile(const fs::path& path)
    : path_(path), target_(followLinks(path)), stream_(nullptr, &std::fclose) {
    // Renaming over a device or a pipe would destroy it.
    std::error_code ignored;
    const fs::file_status status = fs::status(target_, ignored);
    if (fs::is_directory(status)) throw FileError(path, "is a folder; give the name of a file");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw FileError(path, "is not a regular file; only such a file can be replaced");

    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    stream_ = createTemporary(folder, temporary_);
    if (!stream_)
        throw FileError(path,
                        "cannot create a file in the folder '" + folder.string() + "': " + reason(errno));
}

PendingFile::~PendingFile() {
    stream_.reset();
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

// A new file .fringe-PID-N.part in the folder, with the first N that is free: of another output of this
// process, or of one that was killed. Null with errno set when there is none to be had.
PendingFile::Stream PendingFile::createTemporary(const fs::path& folder, fs::path& name) {
    int descriptor = -1;
    for (int n = 0; descriptor < 0; ++n) {
        name = folder / (".fringe-" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".part");
        descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno != EEXIST) return {nullptr, &std::fclose};
    }
    Stream stream(::fdopen(descriptor, "wb"), &std::fclose);
    if (!stream) {
        const int error = errno;
        ::close(descriptor);
        ::unlink(name.c_str());
        errno = error;
    }
    return stream;
}

bool PendingFile::write(const void* bytes, std::size_t size) noexcept {
    if (failure_ == 0 && std::fwrite(bytes, 1, size, stream_.get()) != size) failure_ = errno;
    return failure_ == 0;
}

bool PendingFile::seek(std::uint64_t position) noexcept {
    if (failure_ == 0 && ::fseeko(stream_.get(), static_cast<off_t>(position), SEEK_SET) != 0)
        failure_ = errno;
    return failure_ == 0;
}

std::uint64_t PendingFile::tell() const noexcept {
    return static_cast<std::uint64_t>(::ftello(stream_.get()));
}

void PendingFile::fail(const std::string& otherwise) const {
    throw FileError(path_, "cannot be written: " + (failure_ != 0 ? reason(failure_) : otherwise));
}

void PendingFile::commit() {
    if (failure_ == 0 && std::fclose(stream_.release()) != 0) failure_ = errno;  // the last bytes leave here
    if (failure_ == 0 && std::rename(temporary_.c_str(), target_.c_str()) != 0) failure_ = errno;
    if (failure_ != 0) fail({});
    temporary_.clear();
}

}  // namespace fringe::image
