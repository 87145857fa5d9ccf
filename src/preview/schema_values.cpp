#include "preview/schema_values.hpp"

#include <string_view>

namespace fringe::preview {
namespace {

using scene::JsonType;
using scene::Property;
using scene::Schema;

Json::Value exampleArray(const Schema& schema) {
    Json::Value array(Json::arrayValue);
    for (std::size_t i = 0; i < schema.minItems; ++i) array.append(exampleOf(*schema.items));
    // A direction or a colour of zeros would be refused.
    const bool isVector = !array.empty() && array[0].isNumeric();
    if (isVector) array[array.size() - 1] = 1.0;
    return array;
}

double exampleNumber(const Schema& schema) {
    const double least = schema.lower ? schema.lower->value : 0.0;
    if (schema.lower && schema.upper) return 0.5 * (least + schema.upper->value);
    return schema.lower && schema.lower->exclusive ? least + 1.0 : least;
}

}  // namespace

Json::Value exampleOf(const Schema& schema) {
    if (!schema.defaultValue.isNull()) return schema.defaultValue;
    if (!schema.choices.empty()) return schema.choices.front();
    if (!schema.alternatives.empty()) return exampleOf(schema.alternatives.front());
    if (!schema.example.empty()) return schema.example;
    switch (schema.type.value_or(JsonType::object)) {
        case JsonType::object:
            return adapted(Json::Value(Json::objectValue), schema);
        case JsonType::array:
            return exampleArray(schema);
        case JsonType::string:
            return schema.unit ? schema.lower->text : std::string();
        case JsonType::number:
            return exampleNumber(schema);
        case JsonType::integer:
            return static_cast<Json::Int64>(schema.lower ? schema.lower->value : 1.0);
        case JsonType::boolean:
            return false;
    }
    return {};
}

Json::Value adapted(const Json::Value& value, const Schema& schema) {
    if (schema.type != JsonType::object) return exampleOf(schema);
    Json::Value result(Json::objectValue);
    for (const Property& property : schema.properties) {
        const bool isKnown = value.isObject() && value.isMember(property.name) && !property.isConstant() &&
                             scene::alternativeFor(property.schema, value[property.name]) != nullptr;
        if (isKnown) result[property.name] = value[property.name];
        else if (property.required) result[property.name] = exampleOf(property.schema);
        else if (property.isConstant() && property.schema.defaultValue.isNull())
            result[property.name] = property.schema.choices.front();
    }
    return result;
}

std::string labelOf(const Schema& schema) {
    if (schema.title.empty()) return schema.choices.empty() ? "number" : schema.choices.front().asString();
    std::string_view title = schema.title;
    for (const std::string_view article : {"a ", "an ", "the "}) {
        if (title.starts_with(article)) title.remove_prefix(article.size());
    }
    return std::string(title);
}

}  // namespace fringe::preview
