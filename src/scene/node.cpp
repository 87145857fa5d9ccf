#include "scene/node.hpp"

#include <cassert>
#include <utility>

namespace fringe::scene {
namespace {

// The offset of an override that has set the value or a part of it, such as one component of a vector; else
// that of the value.
std::ptrdiff_t blamed(const Json::Value& value, std::ptrdiff_t offset) {
    if (isOverride(offset)) return offset;
    if (value.isArray() || value.isObject()) {
        for (const Json::Value& inner : value) {
            const std::ptrdiff_t found = blamed(inner, inner.getOffsetStart());
            if (isOverride(found)) return found;
        }
    }
    return offset;
}

}  // namespace

Node::Node(std::string_view key, const Json::Value& value, const Schema& schema, std::ptrdiff_t offset,
           Findings& findings)
    : key_(key),
      value_(&value),
      schema_(alternativeFor(schema, value)),
      offset_(offset),
      findings_(&findings) {
    assert(schema_ != nullptr);
}

Node Node::operator[](std::string_view key) const {
    const Property* property = schema_->find(key);
    assert(property != nullptr);
    if (const Json::Value* found = value_->find(key.data(), key.data() + key.size())) {
        return {property->name, *found, property->schema, found->getOffsetStart(), *findings_};
    }
    return {property->name, property->schema.defaultValue, property->schema, offset_, *findings_};
}

bool Node::has(std::string_view key) const {
    return value_->find(key.data(), key.data() + key.size()) != nullptr;
}

Node Node::element(Json::ArrayIndex index) const {
    const Json::Value& found = (*value_)[index];
    return {key_, found, *schema_->items, found.getOffsetStart(), *findings_};
}

dvec3 Node::vector() const {
    assert(value_->size() == 3);
    auto component = value_->begin();
    const double x = (component++)->asDouble();
    const double y = (component++)->asDouble();
    return {x, y, component->asDouble()};
}

double Node::quantity(Dimension dimension) const {
    assert(schema_->unit == dimension);
    return quantityInSi(value_->asString(), dimension);
}

void Node::refuse(std::string message, std::initializer_list<Node> others) const {
    std::ptrdiff_t offset = blamed(*value_, offset_);
    for (const Node& other : others) {
        const std::ptrdiff_t candidate = blamed(*other.value_, other.offset_);
        if (!isOverride(offset) && isOverride(candidate)) offset = candidate;
    }
    findings_->push_back({offset, std::move(message)});
}

}  // namespace fringe::scene
