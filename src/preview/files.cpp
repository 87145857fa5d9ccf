#include "preview/files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

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

}  // namespace

FileWatch::FileWatch(std::filesystem::path file) : file_(std::move(file)), known_(stamp()) {}

std::optional<FileWatch::Stamp> FileWatch::stamp() const {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file_, error);
    if (error) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(file_, error);
    if (error) return std::nullopt;
    return Stamp{time, size};
}

std::optional<std::string> FileWatch::changedText() {
    const std::optional<Stamp> now = stamp();
    if (!now || now == known_) return std::nullopt;
    std::ifstream stream(file_, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) return std::nullopt;
    known_ = now;
    return text;
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
