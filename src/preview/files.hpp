// What the preview writes, and the file that it watches.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "preview/document.hpp"
#include "preview/wish.hpp"

namespace fringe::preview {

// What changes when a file is written to.
struct FileStamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size;

    bool operator==(const FileStamp&) const = default;
};

// Notices that a file has been written to.
class FileWatch {
public:
    explicit FileWatch(std::filesystem::path file);

    // Its text, if it has been written to since the last call and can be read.
    std::optional<std::string> changedText();

    // What was wrong with the file at the last call; empty: nothing.
    const std::string& problem() const { return problem_; }

private:
    std::filesystem::path file_;
    std::optional<FileStamp> known_;
    std::string problem_;
};

// Notices that a shader of a folder has been written to, made or taken away.
class ShaderWatch {
public:
    // An empty name: of no folder.
    explicit ShaderWatch(std::filesystem::path folder);

    // Whether one has since the last call.
    bool hasChanged();

private:
    using Stamps = std::map<std::filesystem::path, std::optional<FileStamp>>;

    Stamps stamps() const;

    std::filesystem::path folder_;
    Stamps known_;
};

// The scene as it is on show: with what was changed, and seen by `camera` if there is one. As JSON, without
// comments.
std::string sceneText(const Document& document, const std::optional<scene::Camera>& camera);

// Where the changed scene and pictures of it go: beside the scene file, so that the files it names are found,
// "NAME-edited.json"; into the working folder, "NAME-preview.png" and ".exr".
std::filesystem::path editedFile(const Source& source);
std::filesystem::path pictureFile(const Source& source, const char* extension);

// Throws image::FileError.
void saveScene(const std::filesystem::path& file, const std::string& text);

// As a PNG and as an EXR file, with the text of the scene in them. Throws image::FileError. Precondition: the
// picture has its film.
void savePicture(const std::filesystem::path& png, const std::filesystem::path& exr, const Picture& picture,
                 const std::string& sceneText);

}  // namespace fringe::preview
