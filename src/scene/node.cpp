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
           Surroundings& surroundings)
    : key_(key),
      value_(&value),
      schema_(alternativeFor(schema, value)),
      offset_(offset),
      surroundings_(&surroundings) {
    assert(schema_ != nullptr);
}

Node Node::operator[](std::string_view key) const {
    const Property* property = schema_->find(key);
    assert(property != nullptr);
    if (const Json::Value* found = value_->find(key.data(), key.data() + key.size())) {
        return {property->name, *found, property->schema, found->getOffsetStart(), *surroundings_};
    }
    return {property->name, property->schema.defaultValue, property->schema, offset_, *surroundings_};
}

bool Node::has(std::string_view key) const {
    return value_->find(key.data(), key.data() + key.size()) != nullptr;
}

std::vector<Node> Node::elements() const {
    std::vector<Node> nodes;
    nodes.reserve(value_->size());
    for (const Json::Value& value : *value_)
        nodes.emplace_back(key_, value, *schema_->items, value.getOffsetStart(), *surroundings_);
    return nodes;
}

std::vector<Node> Node::entries() const {
    std::vector<Node> nodes;
    for (auto member = value_->begin(); member != value_->end(); ++member) {
        const char* end = nullptr;
        const char* name = member.memberName(&end);
        const std::string_view key(name, static_cast<std::size_t>(end - name));
        if (schema_->find(key) == nullptr)
            nodes.emplace_back(key, *member, *schema_->mapped, member->getOffsetStart(), *surroundings_);
    }
    return nodes;
}

dvec3 Node::vector() const {
    assert(value_->size() == 3);
    auto component = value_->begin();
    const double x = (component++)->asDouble();
    const double y = (component++)->asDouble();
    return {x, y, component->asDouble()};
}

glm::dvec2 Node::lengths() const {
    const std::vector<Node> components = elements();
    assert(components.size() == 2);
    return {components[0].length().si, components[1].length().si};
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
    surroundings_->findings.push_back({offset, std::move(message)});
}

}  // namespace fringe::scene
