#include "preview/document.hpp"

#include <json/writer.h>

#include <algorithm>
#include <optional>

#include "scene/json_text.hpp"
#include "scene/overrides.hpp"
#include "scene/schema.hpp"
#include "scene/validate.hpp"

namespace fringe::preview {
namespace {

// 0.1 as 0.1: as many digits as every decimal number survives with.
constexpr int kDigits = 15;

std::string written(const Json::Value& value, const char* indentation) {
    Json::StreamWriterBuilder builder;
    builder["indentation"] = indentation;
    builder["precision"] = kDigits;
    builder["emitUTF8"] = true;
    return Json::writeString(builder, value);
}

// Nothing when the text is no JSON.
std::optional<Json::Value> rootOf(const Source& source) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    std::string_view text = source.text;
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    scene::Findings findings;
    scene::JsonText json = scene::readJson(text, findings);
    if (!findings.empty()) return std::nullopt;
    scene::applyOverrides(source.overrides, scene::sceneSchema(), json.root, findings);
    return std::move(json.root);
}

}  // namespace

Document::Document(Source source)
    : source_(std::make_shared<const Source>(std::move(source))),
      root_(rootOf(*source_).value_or(Json::Value(Json::objectValue))),
      given_(source_->overrides) {}

void Document::set(const std::string& path, const Json::Value& value) {
    Source next = *source_;
    // What was set before at this place, or inside it, no longer counts.
    const auto isWithin = [&](const scene::Override& other) {
        return other.path == path || other.path.starts_with(path + ".");
    };
    std::erase_if(next.overrides, isWithin);
    next.overrides.push_back({path, jsonText(value)});
    isChanged_ = true;
    scene::Findings findings;
    scene::applyOverrides({&next.overrides.back(), 1}, scene::sceneSchema(), root_, findings);
    source_ = std::make_shared<const Source>(std::move(next));
}

void Document::reload(std::string text) {
    isChanged_ = false;
    source_ = std::make_shared<const Source>(Source{std::move(text), source_->file, given_});
    auto root = rootOf(*source_);
    if (!root) return;
    scene::Findings findings;
    scene::validate(*root, scene::sceneSchema(), {}, findings);
    if (findings.empty()) root_ = std::move(*root);
}

std::string jsonText(const Json::Value& value) {
    return written(value, "");
}

std::string fileText(const Json::Value& value) {
    return written(value, "  ") + "\n";
}

}  // namespace fringe::preview
