#include "scene/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/json_text.hpp"
#include "scene/wording.hpp"

namespace fringe::scene {
namespace {

// Gives the value and all inside it one offset.
void stamp(Json::Value& value, std::ptrdiff_t offset) {
    value.setOffsetStart(offset);
    if (!value.isObject() && !value.isArray()) return;
    for (Json::Value& inner : value) stamp(inner, offset);
}

Json::Value parsedValue(const std::string& text) {
    Findings notJson;
    JsonText parsed = readJson(text, notJson);
    return notJson.empty() ? std::move(parsed.root) : Json::Value(text);
}

std::vector<std::string> segmentsOf(std::string_view path) {
    std::vector<std::string> segments;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        segments.emplace_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return segments;
}

std::vector<std::string> namesIn(const Json::Value& array) {
    std::vector<std::string> names;
    for (const Json::Value& element : array) {
        if (element.isObject() && element["name"].isString()) names.push_back(element["name"].asString());
    }
    return names;
}

// The element with that name, else with that index; null if there is neither.
Json::Value* elementOf(Json::Value& array, const std::string& segment) {
    for (Json::Value& element : array) {
        if (element.isObject() && std::as_const(element)["name"] == segment) return &element;
    }
    Json::ArrayIndex index = 0;
    const char* end = segment.data() + segment.size();
    const auto [stop, error] = std::from_chars(segment.data(), end, index);
    if (error != std::errc{} || stop != end || index >= array.size()) return nullptr;
    return &array[index];
}

// Walks one path through the scene, and the schema beside it for as long as that knows the way.
class Walk {
public:
    Walk(const Override& source, std::ptrdiff_t offset, const Schema& schema, Json::Value& root)
        : segments_(segmentsOf(source.path)), offset_(offset), at_(&root), schema_(&schema) {}

    // Sets the value; or says what is wrong with the path.
    std::optional<std::string> set(Json::Value value) {
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (segments_[i].empty())
                return fmt::format(
                    "segment {} of the path is empty; write keys, names or indices between the dots", i + 1);
            if (std::optional<std::string> fault = step(i)) return fault;
        }
        stamp(value, offset_);
        *at_ = std::move(value);
        return std::nullopt;
    }

private:
    std::optional<std::string> step(std::size_t i) {
        const std::string& segment = segments_[i];
        if (schema_ != nullptr) schema_ = alternativeFor(*schema_, *at_);
        if (at_->isArray()) {
            Json::Value* element = elementOf(*at_, segment);
            if (element == nullptr) return noElement(i);
            at_ = element;
            schema_ = schema_ != nullptr ? schema_->items.get() : nullptr;
            return std::nullopt;
        }
        if (!at_->isObject()) {
            return fmt::format("{} is {}, which has nothing named {}; end the path before it", pathTo(i),
                               spoken(*at_), inQuotes(segment));
        }
        return stepIntoObject(i);
    }

    std::optional<std::string> stepIntoObject(std::size_t i) {
        const std::string& segment = segments_[i];
        const bool last = i + 1 == segments_.size();
        const Property* property = schema_ != nullptr ? schema_->find(segment) : nullptr;
        const bool named = schema_ != nullptr && schema_->mapped && property == nullptr;
        if (!at_->isMember(segment)) {
            if (named && !last) return noMember(i);
            Json::Value made = property != nullptr ? property->schema.defaultValue : Json::Value();
            if (made.isNull() && !last) made = Json::Value(Json::objectValue);
            stamp(made, offset_);
            (*at_)[segment] = std::move(made);
        }
        at_ = &(*at_)[segment];
        schema_ = property != nullptr ? &property->schema : (named ? schema_->mapped.get() : nullptr);
        return std::nullopt;
    }

    std::string noMember(std::size_t i) const {
        if (at_->empty())
            return fmt::format("{} has nothing named {}; it is empty", pathTo(i), inQuotes(segments_[i]));
        return fmt::format("{} has nothing named {}; {}", pathTo(i), inQuotes(segments_[i]),
                           suggestion(segments_[i], at_->getMemberNames(), "write"));
    }

    std::string noElement(std::size_t i) const {
        const std::vector<std::string> names = namesIn(*at_);
        const std::string message = fmt::format("{} has nothing named {}", pathTo(i), inQuotes(segments_[i]));
        if (at_->empty()) return message + "; it is empty";
        const std::string indices = fmt::format("an index from 0 to {}", at_->size() - 1);
        if (names.empty()) return fmt::format("{}; write {}", message, indices);
        return fmt::format("{}; {} (or {})", message, suggestion(segments_[i], names, "write"), indices);
    }

    // "lights.lamp", or "the scene" before the first segment.
    std::string pathTo(std::size_t i) const {
        if (i == 0) return "the scene";
        return fmt::format(
            "\"{}\"", fmt::join(segments_.begin(), segments_.begin() + static_cast<std::ptrdiff_t>(i), "."));
    }

    std::vector<std::string> segments_;
    std::ptrdiff_t offset_;
    Json::Value* at_;
    const Schema* schema_;  // null where the path has left the schema; then validation will refuse the key
};

}  // namespace

void applyOverrides(std::span<const Override> overrides, const Schema& schema, Json::Value& root,
                    Findings& findings) {
    for (std::size_t i = 0; i < overrides.size(); ++i) {
        const std::ptrdiff_t offset = overrideOffset(i);
        Walk walk(overrides[i], offset, schema, root);
        if (std::optional<std::string> fault = walk.set(parsedValue(overrides[i].value))) {
            findings.push_back({offset, std::move(*fault)});
        }
    }
}

}  // namespace fringe::scene
