#include "scene/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/parse.hpp"
#include "scene/wording.hpp"
#include "schema_text.hpp"

namespace fringe::scene {
namespace {

struct TypePhrase {
    JsonType type;
    std::string_view phrase;  // in messages
};

constexpr std::array kTypePhrases{
    TypePhrase{JsonType::object, "an object"},       TypePhrase{JsonType::array, "an array"},
    TypePhrase{JsonType::string, "a string"},        TypePhrase{JsonType::number, "a number"},
    TypePhrase{JsonType::integer, "a whole number"}, TypePhrase{JsonType::boolean, "true or false"},
};

std::string rangeOf(const Schema& schema) {
    const std::optional<Bound>& lower = schema.lower;
    const std::optional<Bound>& upper = schema.upper;
    if (lower && upper && !lower->exclusive && !upper->exclusive) {
        return fmt::format(" from {} to {}", lower->text, upper->text);
    }
    std::string range;
    if (lower) range = fmt::format(" {} {}", lower->exclusive ? "greater than" : "of at least", lower->text);
    if (lower && upper) range += " and";
    if (upper) range += fmt::format(" {} {}", upper->exclusive ? "less than" : "at most", upper->text);
    return range;
}

bool hasConstants(const Json::Value& object, const Schema& schema) {
    return std::all_of(schema.properties.begin(), schema.properties.end(), [&](const Property& property) {
        if (!property.isConstant()) return true;
        const Json::Value* written =
            object.find(property.name.data(), property.name.data() + property.name.size());
        return written != nullptr ? *written == property.schema.choices.front() : !property.required;
    });
}

// The noun phrase alone: "a number of metres", "true or false".
std::string nounOf(const Schema& schema) {
    if (!schema.title.empty()) return schema.title;
    for (const TypePhrase& known : kTypePhrases) {
        if (schema.type == known.type) return std::string(known.phrase);
    }
    return {};
}

}  // namespace

const Property* Schema::find(std::string_view name) const {
    for (const Property& property : properties) {
        if (property.name == name) return &property;
    }
    return nullptr;
}

std::vector<std::string> Schema::propertyList() const {
    std::vector<std::string> names;
    for (const Property& property : properties) names.push_back(property.name);
    return names;
}

std::string_view schemaText() {
    return embedded::schema;
}

const Schema& sceneSchema() {
    static const Schema schema = readSchema(schemaText());
    return schema;
}

bool hasType(const Json::Value& value, JsonType type) {
    switch (type) {
        case JsonType::object:
            return value.isObject();
        case JsonType::array:
            return value.isArray();
        case JsonType::string:
            return value.isString();
        case JsonType::number:
            return value.isNumeric();
        case JsonType::integer:
            return value.isIntegral();
        case JsonType::boolean:
            return value.isBool();
    }
    return false;
}

const Schema* alternativeFor(const Schema& schema, const Json::Value& value) {
    if (schema.alternatives.empty()) return &schema;
    for (const Schema& alternative : schema.alternatives) {
        if (!hasType(value, *alternative.type)) continue;
        if (!value.isObject() || hasConstants(value, alternative)) return &alternative;
    }
    return nullptr;
}

std::string expectation(const Schema& schema) {
    if (!schema.choices.empty()) {
        std::vector<std::string> choices;
        for (const Json::Value& choice : schema.choices) choices.push_back(spoken(choice));
        return anyOf(choices);
    }
    if (!schema.example.empty()) return fmt::format("{} such as \"{}\"", nounOf(schema), schema.example);
    return nounOf(schema);
}

std::string expectationInRange(const Schema& schema) {
    return nounOf(schema) + rangeOf(schema);
}

}  // namespace fringe::scene
