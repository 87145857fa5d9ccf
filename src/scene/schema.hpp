// The JSON Schema of scene files as a tree that is quick to walk. It understands exactly the keywords that
// scenes/fringe.schema.json uses, and the reader of a schema throws on any other, so that nothing an editor
// checks goes unchecked here. Besides the standard keywords there are annotations of our own:
//   unit                               the dimension of a quantity in a string
//   quantityMinimum, quantityMaximum, quantityExclusiveMinimum, quantityExclusiveMaximum   its range
//   maximumReason                      why larger magnitudes are refused
//   rangeReason                        why what is outside the range, on either side, is refused
// A "title" is a noun phrase ("a sphere") which messages use.
#pragma once

#include <json/value.h>

#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "scene/quantity.hpp"

namespace fringe::scene {

enum class JsonType { object, array, string, number, integer, boolean };

struct Bound {
    double value;  // SI where the schema has a unit
    bool exclusive;
    std::string text;  // as the schema writes it
};

struct Property;

struct Schema {
    std::string title;
    std::string description;  // a sentence or more for whoever writes a scene
    std::optional<JsonType> type;
    std::vector<Json::Value> choices;  // the values of enum or const; none: no such limit
    Json::Value defaultValue;          // null: none
    std::string example;               // such as "1 um"

    std::optional<Bound> lower;  // of a number or a quantity
    std::optional<Bound> upper;
    std::string maximumReason;
    std::string rangeReason;
    std::optional<Dimension> unit;  // the string is a quantity

    std::size_t minLength = 0;          // of a string, in bytes: only 0 and 1 are understood
    std::optional<std::regex> pattern;  // of the name of a property; a quantity is known by its unit

    std::unique_ptr<const Schema> items;  // of an array
    std::size_t minItems = 0;
    std::optional<std::size_t> maxItems;

    std::vector<Property> properties;             // of an object, in the order of the schema
    std::unique_ptr<const Schema> mapped;         // of the values under any other key; null: no other key
    std::unique_ptr<const Schema> propertyNames;  // of those other keys

    // oneOf: objects that differ in constants, as of "type" or "model", and values that differ in their JSON
    // type.
    std::vector<Schema> alternatives;

    const Property* find(std::string_view name) const;  // null: no such property
    std::vector<std::string> propertyList() const;
};

struct Property {
    std::string name;
    bool required;
    Schema schema;

    // The key can have one value only, such as "type": it tells an alternative from the others.
    bool isConstant() const { return schema.choices.size() == 1; }
};

// Reads the text of a schema. Throws std::logic_error on a keyword or a form of one that the validator would
// not honour: the schema is part of the program.
Schema readSchema(std::string_view text);

// The schema of scenes, read at first use.
const Schema& sceneSchema();

bool hasType(const Json::Value& value, JsonType type);

// The alternative which the value takes up, by its constants or its JSON type, or the schema itself where it
// has none; null if the value fits none of them. An object without "type" takes the alternative that needs
// none, and the same goes for other constants.
const Schema* alternativeFor(const Schema& schema, const Json::Value& value);

// What the schema wants, for "write ...": a number of metres; a length such as "1 um"; "limit" or
// "as-printed".
std::string expectation(const Schema& schema);

// The same with its range: an angle greater than 0 deg and less than 180 deg.
std::string expectationInRange(const Schema& schema);

}  // namespace fringe::scene
