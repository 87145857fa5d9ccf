// A file that appears whole or not at all: it grows under a temporary name in the folder of its target
// and takes the target's name in commit().
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "image/file_error.hpp"

namespace fringe::image {

class PendingFile {
public:
    // Create the temporary file, with the permissions that the umask leaves. A symbolic link is followed:
    // what it points at is the target. Throws FileError when the target exists and is no regular file,
    // or when its folder takes no new file.
    explicit PendingFile(const std::filesystem::path& path);
    ~PendingFile();  // without commit() the temporary file is removed
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    // Write at the current position; move it; tell it. They are noexcept so that C libraries may call them.
    // False after a failure, whose reason is kept for fail() and commit(); it is final.
    bool write(const void* bytes, std::size_t size) noexcept;
    bool seek(std::uint64_t position) noexcept;
    std::uint64_t tell() const noexcept;

    // Throw FileError with the reason of the first failure, or with `otherwise` if none happened here.
    [[noreturn]] void fail(const std::string& otherwise) const;

    // Close the file and rename it over the target. Throws FileError, also for any earlier failure.
    void commit();

private:
    using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
    static Stream createTemporary(const std::filesystem::path& folder, std::filesystem::path& name);

    std::filesystem::path path_;       // as the user gave it, for messages
    std::filesystem::path target_;     // path_ without its links
    std::filesystem::path temporary_;  // empty once it is gone
    Stream stream_;
    int failure_ = 0;  // errno of the first failure
};

}  // namespace fringe::image
