// The rows of a picture, kept until something about the whole of it is known: in memory, or when they are too
// many, in a temporary file without a name that vanishes with its owner.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "image/file_error.hpp"
#include "image/image.hpp"

namespace fringe::image {

class Spool {
public:
    static constexpr std::size_t kMemory = std::size_t{256} << 20U;  // bytes

    // For rows of `width` pixels. At most `memory` bytes are held besides the rows that come in at once.
    explicit Spool(std::uint32_t width, std::size_t memory = kMemory);

    // Append whole rows. Throws FileError when the folder for temporary files takes no more.
    void append(std::span<const Pixel> rows);

    // All rows, in order, some at a time. Throws FileError, and what `sink` throws.
    void replay(const std::function<void(std::span<const Pixel>)>& sink) const;

private:
    using Stream = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
    void openFile();
    void moveToFile();

    std::size_t width_;
    std::size_t memory_;
    std::filesystem::path folder_;          // of the file
    Stream file_;                           // the first rows, once there are too many
    std::size_t inFile_ = 0;                // rows
    std::vector<std::vector<Pixel>> kept_;  // the rows after them, as they came
    std::size_t inMemory_ = 0;              // bytes
};

}  // namespace fringe::image
