#include "scene/schema.hpp"

#include <fmt/format.h>
#include <json/reader.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

#include "scene/parse.hpp"
#include "scene/wording.hpp"
#include "schema_text.hpp"

namespace fringe::scene {
namespace {

[[noreturn]] void refuse(std::string_view what, std::string_view why) {
    throw std::logic_error(fmt::format("scene schema: {}: {}", what, why));
}

struct TypeName {
    std::string_view name;
    JsonType type;
    std::string_view phrase;  // in messages
};

constexpr std::array kTypes{
    TypeName{"object", JsonType::object, "an object"},
    TypeName{"array", JsonType::array, "an array"},
    TypeName{"string", JsonType::string, "a string"},
    TypeName{"number", JsonType::number, "a number"},
    TypeName{"integer", JsonType::integer, "a whole number"},
    TypeName{"boolean", JsonType::boolean, "true or false"},
};

// Turns the schema's JSON into the tree: references are replaced by what they refer to.
class Reader {
public:
    explicit Reader(const Json::Value& root) : root_(root) {}

    Schema read(const Json::Value& written) const {
        const Json::Value source = resolved(written);
        Schema schema;
        for (auto member = source.begin(); member != source.end(); ++member) {
            const auto keyword = keywords().find(member.name());
            if (keyword == keywords().end()) refuse(member.name(), "no such keyword is understood here");
            (this->*keyword->second)(source, *member, schema);
        }
        requireComplete(source, schema);
        return schema;
    }

private:
    // What JSON Schema would let pass, but the validator does not.
    static void requireComplete(const Json::Value& source, const Schema& schema) {
        if (!schema.type && schema.choices.empty() && schema.alternatives.empty()) {
            refuse(schema.title, "needs a type, choices or alternatives");
        }
        if (schema.type == JsonType::object && !source.isMember("additionalProperties")) {
            refuse(schema.title, "an object needs additionalProperties, since unknown keys are refused");
        }
        if (schema.mapped && !schema.propertyNames) refuse(schema.title, "a map needs propertyNames");
        if (schema.type == JsonType::array && !schema.items) refuse(schema.title, "an array needs items");
        if (schema.unit && schema.example.empty()) refuse(schema.title, "a quantity needs an example");
    }

    using Keyword = void (Reader::*)(const Json::Value& source, const Json::Value& value, Schema&) const;

    static const std::map<std::string, Keyword, std::less<>>& keywords() {
        static const std::map<std::string, Keyword, std::less<>> table{
            {"$schema", &Reader::ignore},
            {"$defs", &Reader::ignore},
            {"description", &Reader::ignore},
            {"pattern", &Reader::pattern},
            {"title", &Reader::title},
            {"type", &Reader::type},
            {"const", &Reader::constant},
            {"enum", &Reader::enumeration},
            {"default", &Reader::defaultValue},
            {"examples", &Reader::examples},
            {"minimum", &Reader::minimum},
            {"maximum", &Reader::maximum},
            {"exclusiveMinimum", &Reader::exclusiveMinimum},
            {"maximumReason", &Reader::maximumReason},
            {"unit", &Reader::unit},
            {"quantityMinimum", &Reader::minimum},
            {"quantityMaximum", &Reader::maximum},
            {"quantityExclusiveMinimum", &Reader::exclusiveMinimum},
            {"quantityExclusiveMaximum", &Reader::exclusiveMaximum},
            {"minLength", &Reader::minLength},
            {"items", &Reader::items},
            {"minItems", &Reader::minItems},
            {"maxItems", &Reader::maxItems},
            {"properties", &Reader::properties},
            {"required", &Reader::required},
            {"additionalProperties", &Reader::additionalProperties},
            {"propertyNames", &Reader::propertyNames},
            {"oneOf", &Reader::oneOf},
        };
        return table;
    }

    // The schema itself, or what its $ref leads to with the keywords beside the $ref added. Those may replace
    // annotations only: to narrow an assertion, JSON Schema would apply both.
    Json::Value resolved(const Json::Value& written) const {
        if (!written.isMember("$ref")) return written;
        Json::Value merged = resolved(target(written["$ref"].asString()));
        for (auto member = written.begin(); member != written.end(); ++member) {
            const std::string name = member.name();
            if (name == "$ref") continue;
            const bool annotation =
                name == "title" || name == "description" || name == "default" || name == "examples";
            if (merged.isMember(name) && !annotation)
                refuse(name, "is also in what the $ref beside it leads to");
            merged[name] = *member;
        }
        return merged;
    }

    const Json::Value& target(const std::string& reference) const {
        if (!reference.starts_with("#/"))
            refuse(reference, "only references into this schema are understood");
        const Json::Value* at = &root_;
        for (std::size_t begin = 2; begin <= reference.size();) {
            const std::size_t end = std::min(reference.find('/', begin), reference.size());
            const std::string segment = reference.substr(begin, end - begin);
            if (!at->isObject() || !at->isMember(segment)) refuse(reference, "leads nowhere");
            at = &(*at)[segment];
            begin = end + 1;
        }
        return *at;
    }

    void ignore(const Json::Value&, const Json::Value&, Schema&) const {}

    // Editors need a pattern; here splitQuantity and the unit say the same (a test compares them).
    void pattern(const Json::Value& source, const Json::Value&, Schema&) const {
        if (!source.isMember("unit"))
            refuse("pattern", "only that of a quantity is understood, beside a unit");
    }

    void title(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.title = value.asString();
    }

    void type(const Json::Value&, const Json::Value& value, Schema& schema) const {
        for (const TypeName& known : kTypes) {
            if (known.name == value.asString()) schema.type = known.type;
        }
        if (!schema.type) refuse("type", value.asString());
    }

    void constant(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.choices = {value};
    }

    void enumeration(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.choices.assign(value.begin(), value.end());
    }

    void defaultValue(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.defaultValue = value;
    }

    void examples(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.example = value[0].asString();
    }

    Bound bound(const Json::Value& source, const Json::Value& value, bool exclusive) const {
        if (!value.isString()) return {value.asDouble(), exclusive, spoken(value)};
        const std::optional<Dimension> dimension = dimensionNamed(source["unit"].asString());
        if (!dimension) refuse(value.asString(), "a range with a unit belongs beside that unit");
        return {quantityInSi(value.asString(), *dimension), exclusive, value.asString()};
    }

    void minimum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.lower = bound(source, value, false);
    }

    void exclusiveMinimum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.lower = bound(source, value, true);
    }

    void maximum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.upper = bound(source, value, false);
    }

    void exclusiveMaximum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.upper = bound(source, value, true);
    }

    void maximumReason(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.maximumReason = value.asString();
    }

    void unit(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.unit = dimensionNamed(value.asString());
        if (!schema.unit) refuse("unit", value.asString());
    }

    void minLength(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.minLength = value.asUInt();
        if (schema.minLength > 1) refuse("minLength", "only 0 and 1 are understood");
    }

    void items(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.items = std::make_unique<const Schema>(read(value));
    }

    void minItems(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.minItems = value.asUInt();
    }

    void maxItems(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.maxItems = value.asUInt();
    }

    void properties(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        const Json::Value& required = source["required"];
        std::vector<std::pair<std::ptrdiff_t, std::string>> names;  // in the order of the text
        for (auto member = value.begin(); member != value.end(); ++member) {
            names.emplace_back(member->getOffsetStart(), member.name());
        }
        std::sort(names.begin(), names.end());
        for (auto& [offset, name] : names) {
            const bool needed = std::find(required.begin(), required.end(), name) != required.end();
            schema.properties.push_back({name, needed, read(value[name])});
        }
    }

    void required(const Json::Value& source, const Json::Value& value, Schema&) const {
        for (const Json::Value& name : value) {
            if (!source["properties"].isMember(name.asString()))
                refuse(name.asString(), "required but not defined");
        }
    }

    void additionalProperties(const Json::Value&, const Json::Value& value, Schema& schema) const {
        if (value.isObject()) {
            schema.mapped = std::make_unique<const Schema>(read(value));
        } else if (!value.isBool() || value.asBool()) {
            refuse("additionalProperties", "only false and a schema are understood");
        }
    }

    void propertyNames(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.propertyNames = std::make_unique<const Schema>(read(value));
    }

    void oneOf(const Json::Value&, const Json::Value& value, Schema& schema) const {
        for (const Json::Value& alternative : value) {
            schema.alternatives.push_back(read(alternative));
            const Schema& read = schema.alternatives.back();
            const bool typed = read.find("type") != nullptr && read.find("type")->schema.choices.size() == 1;
            if (!read.type || (read.type == JsonType::object && !typed)) {
                refuse("oneOf", "an alternative needs a type, and an object the constant of a key \"type\"");
            }
        }
    }

    const Json::Value& root_;
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

// The noun phrase alone: "a number of metres", "true or false".
std::string nounOf(const Schema& schema) {
    if (!schema.title.empty()) return schema.title;
    for (const TypeName& known : kTypes) {
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

Schema readSchema(std::string_view text) {
    Json::Value root;
    std::string errors;
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder{}.newCharReader());
    if (!reader->parse(text.data(), text.data() + text.size(), &root, &errors)) refuse("text", errors);
    return Reader(root).read(root);
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
    constexpr std::string_view kType = "type";
    const Json::Value* written =
        value.isObject() ? value.find(kType.data(), kType.data() + kType.size()) : nullptr;
    for (const Schema& alternative : schema.alternatives) {
        if (!hasType(value, *alternative.type)) continue;
        if (!value.isObject()) return &alternative;
        const Property& type = *alternative.find(kType);
        if (written != nullptr ? *written == type.schema.choices.front() : !type.required)
            return &alternative;
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
