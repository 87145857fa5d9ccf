// What the world did wrong: the only exception of the image library that names a file.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fringe::image {

// The message reads "PATH: what is wrong; what would be right".
class FileError : public std::runtime_error {
public:
    FileError(const std::filesystem::path& path, const std::string& what)
        : std::runtime_error(path.string() + ": " + what) {}
};

}  // namespace fringe::image
