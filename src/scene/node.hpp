// A value of a validated scene together with its schema: reading a key that is absent gives the schema's
// default. All accessors are total on sound values; asking for the wrong type is a bug.
#pragma once

#include <json/value.h>

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "scene/findings.hpp"
#include "scene/scene.hpp"
#include "scene/schema.hpp"

namespace fringe::scene {

// What lies around the values: where their problems go, and where the files are that they name.
struct Surroundings {
    Findings& findings;
    std::filesystem::path folder;
};

class Node {
public:
    // `key`: what messages call the value; `offset`: the place of its problems. What is passed by view or
    // reference outlives the node.
    Node(std::string_view key, const Json::Value& value, const Schema& schema, std::ptrdiff_t offset,
         Surroundings& surroundings);

    std::string_view key() const { return key_; }

    // The value under a key of the schema, or its default, which has the place of this node.
    Node operator[](std::string_view key) const;
    bool has(std::string_view key) const;  // in the scene itself: defaults do not count

    std::vector<Node> elements() const;  // of an array
    std::vector<Node> entries() const;   // of a map: what has a key that the schema does not name

    bool isNumber() const { return value_->isNumeric(); }
    bool isText() const { return value_->isString(); }
    bool isArray() const { return value_->isArray(); }
    double number() const { return value_->asDouble(); }
    std::uint32_t count() const { return value_->asUInt(); }
    bool flag() const { return value_->asBool(); }
    std::string text() const { return value_->asString(); }
    dvec3 vector() const;
    glm::dvec2 lengths() const;  // of a vector [x, y] of lengths, in metres

    // Quantities, in the dimension of the schema.
    units::Length length() const { return {quantity(Dimension::length)}; }
    units::Angle angle() const { return {quantity(Dimension::angle)}; }
    units::Power power() const { return {quantity(Dimension::power)}; }
    units::Irradiance irradiance() const { return {quantity(Dimension::irradiance)}; }
    units::Radiance radiance() const { return {quantity(Dimension::radiance)}; }
    units::Temperature temperature() const { return {quantity(Dimension::temperature)}; }

    // Records a problem at this value. `others` are the values that made it together with this one: where one
    // of them was set by an override, and this one was not, the problem is put down to that override.
    void refuse(std::string message, std::initializer_list<Node> others = {}) const;

    const std::filesystem::path& folder() const { return surroundings_->folder; }

private:
    double quantity(Dimension dimension) const;

    std::string_view key_;
    const Json::Value* value_;
    const Schema* schema_;
    std::ptrdiff_t offset_;
    Surroundings* surroundings_;
};

}  // namespace fringe::scene
