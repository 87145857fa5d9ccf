// The text of a schema -> Schema. Every keyword that is not listed here is refused.
#include <fmt/format.h>
#include <json/reader.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "scene/schema.hpp"
#include "scene/wording.hpp"

namespace fringe::scene {
namespace {

[[noreturn]] void refuse(std::string_view what, std::string_view why) {
    throw std::logic_error(fmt::format("scene schema: {}: {}", what, why));
}

struct TypeName {
    std::string_view name;
    JsonType type;
};

constexpr std::array kTypes{
    TypeName{"object", JsonType::object},   TypeName{"array", JsonType::array},
    TypeName{"string", JsonType::string},   TypeName{"number", JsonType::number},
    TypeName{"integer", JsonType::integer}, TypeName{"boolean", JsonType::boolean},
};

// Turns the schema's JSON into the tree: references are replaced by what they refer to.
class Reader {
public:
    explicit Reader(const Json::Value& root) : root_(root) {}

    Schema read(const Json::Value& written) const {
        Schema schema;
        apply(written, schema);
        requireComplete(schema);
        return schema;
    }

private:
    // The keywords of what a $ref leads to, and then those beside it. These may replace annotations only: to
    // narrow an assertion, JSON Schema would apply both.
    void apply(const Json::Value& written, Schema& schema) const {
        const bool refers = written.isMember("$ref");
        if (refers) apply(target(written["$ref"].asString()), schema);
        for (auto member = written.begin(); member != written.end(); ++member) {
            const std::string name = member.name();
            if (name == "$ref") continue;
            const bool annotation =
                name == "title" || name == "description" || name == "default" || name == "examples";
            if (refers && !annotation && says(target(written["$ref"].asString()), name))
                refuse(name, "is also in what the $ref beside it leads to");
            const auto keyword = keywords().find(name);
            if (keyword == keywords().end()) refuse(name, "no such keyword is understood here");
            (this->*keyword->second)(written, *member, schema);
        }
        if (written["type"] == "object" && !written.isMember("additionalProperties"))
            refuse(schema.title, "an object needs additionalProperties, since unknown keys are refused");
    }

    bool says(const Json::Value& written, const std::string& keyword) const {
        if (written.isMember(keyword)) return true;
        return written.isMember("$ref") && says(target(written["$ref"].asString()), keyword);
    }

    // What JSON Schema would let pass, but the validator does not.
    static void requireComplete(const Schema& schema) {
        if (!schema.type && schema.choices.empty() && schema.alternatives.empty()) {
            refuse(schema.title, "needs a type, choices or alternatives");
        }
        for (const Property& property : schema.properties) requireNoPattern(property.schema);
        if (schema.items) requireNoPattern(*schema.items);
        if (schema.mapped) requireNoPattern(*schema.mapped);
        for (const Schema& alternative : schema.alternatives) requireNoPattern(alternative);
        if (schema.mapped && !schema.propertyNames) refuse(schema.title, "a map needs propertyNames");
        if (schema.type == JsonType::array && !schema.items) refuse(schema.title, "an array needs items");
        if (schema.unit && schema.example.empty()) refuse(schema.title, "a quantity needs an example");
    }

    static void requireNoPattern(const Schema& schema) {
        if (schema.pattern)
            refuse(schema.title, "a pattern is understood in propertyNames and beside a unit only");
    }

    using Keyword = void (Reader::*)(const Json::Value& source, const Json::Value& value, Schema&) const;

    static const std::map<std::string, Keyword, std::less<>>& keywords() {
        static const std::map<std::string, Keyword, std::less<>> table{
            {"$schema", &Reader::ignore},
            {"$defs", &Reader::ignore},
            {"description", &Reader::description},
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
            {"rangeReason", &Reader::rangeReason},
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

    // Editors need the pattern of a quantity; here splitQuantity and the unit say the same (a test compares
    // them). Any other is honoured in propertyNames alone.
    void pattern(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        if (source.isMember("unit")) return;
        if (source["type"] != "string" || !source.isMember("examples"))
            refuse("pattern", "belongs to a string with an example of what is right");
        schema.pattern.emplace(value.asString(), std::regex::ECMAScript);
    }

    void title(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.title = value.asString();
    }

    void description(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.description = value.asString();
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

    // `known`: the dimension of what a $ref beside the bound leads to; a unit beside it comes after it.
    Bound bound(const Json::Value& source, const Json::Value& value, const std::optional<Dimension>& known,
                bool exclusive) const {
        if (!value.isString()) return {value.asDouble(), exclusive, spoken(value)};
        const std::optional<Dimension> dimension = known ? known : dimensionNamed(source["unit"].asString());
        if (!dimension) refuse(value.asString(), "a range with a unit belongs beside that unit");
        return {quantityInSi(value.asString(), *dimension), exclusive, value.asString()};
    }

    void minimum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.lower = bound(source, value, schema.unit, false);
    }

    void exclusiveMinimum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.lower = bound(source, value, schema.unit, true);
    }

    void maximum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.upper = bound(source, value, schema.unit, false);
    }

    void exclusiveMaximum(const Json::Value& source, const Json::Value& value, Schema& schema) const {
        schema.upper = bound(source, value, schema.unit, true);
    }

    void maximumReason(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.maximumReason = value.asString();
    }

    void rangeReason(const Json::Value&, const Json::Value& value, Schema& schema) const {
        schema.rangeReason = value.asString();
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
            const bool told = std::any_of(read.properties.begin(), read.properties.end(),
                                          [](const Property& property) { return property.isConstant(); });
            if (!read.type || (read.type == JsonType::object && !told)) {
                refuse("oneOf", "an alternative needs a type, and an object a key that is constant");
            }
        }
    }

    const Json::Value& root_;
};

}  // namespace

Schema readSchema(std::string_view text) {
    Json::Value root;
    std::string errors;
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder{}.newCharReader());
    if (!reader->parse(text.data(), text.data() + text.size(), &root, &errors)) refuse("text", errors);
    return Reader(root).read(root);
}

}  // namespace fringe::scene
