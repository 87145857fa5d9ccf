#include "preview/files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "image/pending_file.hpp"
#include "image/writer.hpp"
#include "optics/color.hpp"

namespace fringe::preview {
namespace {

Json::Value pointJson(const glm::dvec3& point) {
    constexpr double kMicrometres = 1e6;  // finer than a hand on a mouse
    Json::Value json(Json::arrayValue);
    for (int i = 0; i < 3; ++i) json.append(std::round(point[i] * kMicrometres) / kMicrometres);
    return json;
}

void setCamera(const scene::Camera& camera, Json::Value& json) {
    json["position"] = pointJson(camera.position);
    json["target"] = pointJson(camera.target);
    json["up"] = pointJson(camera.up);
    if (const auto* orthographic = std::get_if<scene::Orthographic>(&camera.projection))
        json["height"] = orthographic->height;
}

// Nothing of what is no file, or no longer one.
std::optional<FileStamp> stampOf(const std::filesystem::path& file) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    if (error) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) return std::nullopt;
    return FileStamp{time, size};
}

}  // namespace

FileWatch::FileWatch(std::filesystem::path file) : file_(std::move(file)), known_(stampOf(file_)) {}

std::optional<std::string> FileWatch::changedText() {
    const std::optional<FileStamp> now = stampOf(file_);
    if (!now) {
        problem_ = fmt::format("{} is no longer there; it is read again when it comes back", file_.string());
        return std::nullopt;
    }
    if (now == known_) {
        problem_.clear();
        return std::nullopt;
    }
    std::ifstream stream(file_, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        problem_ = fmt::format("{} has changed, but cannot be read", file_.string());
        return std::nullopt;
    }
    problem_.clear();
    known_ = now;
    return text;
}

ShaderWatch::ShaderWatch(std::filesystem::path folder) : folder_(std::move(folder)), known_(stamps()) {}

ShaderWatch::Stamps ShaderWatch::stamps() const {
    Stamps found;
    std::error_code error;  // a folder that is not there has no files
    for (std::filesystem::directory_iterator entry(folder_, error), end; !error && entry != end;
         entry.increment(error)) {
        // Not the copies that editors keep beside it.
        const std::filesystem::path extension = entry->path().extension();
        if (extension == ".comp" || extension == ".glsl" || extension == ".h")
            found[entry->path()] = stampOf(entry->path());
    }
    return found;
}

bool ShaderWatch::hasChanged() {
    if (folder_.empty()) return false;
    Stamps now = stamps();
    return std::exchange(known_, std::move(now)) != known_;
}

std::string sceneText(const Document& document, const std::optional<scene::Camera>& camera) {
    Json::Value root = document.root();
    if (camera) setCamera(*camera, root["camera"]);
    return fileText(root);
}

std::filesystem::path editedFile(const Source& source) {
    const std::filesystem::path file = source.file;
    return file.parent_path() / (file.stem().string() + "-edited.json");
}

std::filesystem::path pictureFile(const Source& source, const char* extension) {
    return std::filesystem::path(source.file).stem().string() + "-preview" + extension;
}

void saveScene(const std::filesystem::path& file, const std::string& text) {
    image::PendingFile pending(file);
    pending.write(text.data(), text.size());
    pending.commit();
}

void savePicture(const std::filesystem::path& png, const std::filesystem::path& exr, const Picture& picture,
                 const std::string& sceneText) {
    image::OutputOptions options;
    options.development = picture.development;
    options.whiteLuminance = optics::luminousEfficacyOfD65();
    options.metadata = {{"Software", "fringe preview"},
                        {"fringe options", fmt::format("{}x{}, {} samples, exposure {:g}", picture.width,
                                                       picture.height, picture.samples, picture.exposure)},
                        {"fringe scene", sceneText}};
    image::writeImage(png, *picture.film, options);
    image::writeImage(exr, *picture.film, options);
}

}  // namespace fringe::preview
