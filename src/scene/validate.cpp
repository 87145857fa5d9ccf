#include "scene/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "scene/wording.hpp"

namespace fringe::scene {
namespace {

// How a value was reached, so that its name in messages is only put together when there is one.
struct Trail {
    const Trail* parent;
    std::string_view key;    // empty for an element of an array
    Json::ArrayIndex index;  // of that element

    // "radius", "center"[1], the scene
    std::string subject() const {
        if (parent == nullptr) return "the scene";
        if (key.data() != nullptr) return inQuotes(key);
        return fmt::format("{}[{}]", parent->subject(), index);
    }
};

class Validator {
public:
    Validator(const std::vector<KeyPlace>& keys, Findings& findings) : keys_(keys), findings_(findings) {}

    bool check(const Json::Value& value, const Schema& schema, const Trail& trail) {
        const Schema* chosen = alternativeFor(schema, value);
        const bool sound =
            chosen != nullptr ? checkChosen(value, *chosen, trail) : refuseType(value, schema, trail);
        if (!sound) unsound.insert(&value);
        return sound;
    }

    Unsound unsound;

private:
    bool report(std::ptrdiff_t offset, std::string message) {
        findings_.push_back({offset, std::move(message)});
        return false;
    }

    bool checkChosen(const Json::Value& value, const Schema& schema, const Trail& trail) {
        if (!schema.choices.empty()) return checkChoice(value, schema, trail);
        if (!hasType(value, *schema.type)) return refuseType(value, schema, trail);
        switch (*schema.type) {
            case JsonType::object:
                return checkObject(value, schema, trail);
            case JsonType::array:
                return checkArray(value, schema, trail);
            case JsonType::string:
                return schema.unit ? checkQuantity(value, schema, trail) : checkText(value, schema, trail);
            case JsonType::number:
            case JsonType::integer:
                return checkRange(value.asDouble(), value, schema, trail);
            case JsonType::boolean:
                return true;
        }
        return true;
    }

    bool checkChoice(const Json::Value& value, const Schema& schema, const Trail& trail) {
        const auto isValue = [&](const Json::Value& choice) {
            const bool numbers = choice.isNumeric() && value.isNumeric();  // 1 and 1.0 are the same number
            return numbers ? choice.asDouble() == value.asDouble() : choice == value;
        };
        if (std::any_of(schema.choices.begin(), schema.choices.end(), isValue)) return true;
        return refuseChoice(value, schema.choices, trail.subject());
    }

    bool refuseChoice(const Json::Value& value, const std::vector<Json::Value>& choices,
                      const std::string& subject) {
        std::vector<std::string> texts;
        for (const Json::Value& choice : choices)
            texts.push_back(choice.isString() ? choice.asString() : spoken(choice));
        std::string remedy = fmt::format("write {}", spoken(choices.front()));
        if (choices.front().isString()) {
            remedy = suggestion(value.isString() ? value.asString() : std::string(), texts, "write");
        }
        return report(value.getOffsetStart(), fmt::format("{} is {}; {}", subject, spoken(value), remedy));
    }

    // The value has none of the types, or as an object none of the constants, that the schema knows.
    bool refuseType(const Json::Value& value, const Schema& schema, const Trail& trail) {
        const auto discriminated = [&](const Schema& alternative) {
            return alternative.type == JsonType::object;
        };
        const auto& alternatives = schema.alternatives;
        if (value.isObject() && std::any_of(alternatives.begin(), alternatives.end(), discriminated)) {
            return refuseConstants(value, schema);
        }
        if (schema.unit && value.isNumeric()) {
            return report(value.getOffsetStart(),
                          fmt::format("{} is the bare number {}, which has no unit; write {}",
                                      trail.subject(), spoken(value), expectation(schema)));
        }
        return report(value.getOffsetStart(),
                      fmt::format("{} is {}; write {}", trail.subject(), spoken(value), expectation(schema)));
    }

    // Goes through the constant keys, "type" first as the schema has it, until no alternative is left.
    bool refuseConstants(const Json::Value& object, const Schema& schema) {
        std::vector<const Schema*> left;
        for (const Schema& alternative : schema.alternatives) {
            if (alternative.type == JsonType::object) left.push_back(&alternative);
        }
        std::vector<std::string_view> checked;
        while (const Property* key = constantOf(left, checked)) {
            checked.push_back(key->name);
            const bool written = object.isMember(key->name);
            std::vector<Json::Value> choices;
            std::vector<const Schema*> fitting;
            for (const Schema* alternative : left) {
                const Property* own = alternative->find(key->name);
                if (own == nullptr || !own->isConstant()) {
                    fitting.push_back(alternative);
                    continue;
                }
                const Json::Value& choice = own->schema.choices.front();
                if (std::find(choices.begin(), choices.end(), choice) == choices.end())
                    choices.push_back(choice);
                if (written ? object[key->name] == choice : !own->required) fitting.push_back(alternative);
            }
            if (fitting.empty() && written)
                return refuseChoice(object[key->name], choices, inQuotes(key->name));
            if (fitting.empty()) return refuseMissing(object, *key, choices);
            left = std::move(fitting);
        }
        assert(false);  // what is left would have been the alternative
        return false;
    }

    // A constant key of the alternatives that is not among those checked; null if there is none.
    static const Property* constantOf(const std::vector<const Schema*>& alternatives,
                                      const std::vector<std::string_view>& checked) {
        for (const Schema* alternative : alternatives) {
            for (const Property& property : alternative->properties) {
                const bool isNew = std::find(checked.begin(), checked.end(), property.name) == checked.end();
                if (property.isConstant() && isNew) return &property;
            }
        }
        return nullptr;
    }

    bool refuseMissing(const Json::Value& object, const Property& key,
                       const std::vector<Json::Value>& choices) {
        std::vector<std::string> words;
        for (const Json::Value& choice : choices) words.push_back(spoken(choice));
        return report(object.getOffsetStart(),
                      fmt::format("missing key \"{}\"; add {}", key.name, anyOf(words)));
    }

    bool checkObject(const Json::Value& value, const Schema& schema, const Trail& trail) {
        bool sound = true;
        for (auto member = value.begin(); member != value.end(); ++member) {
            const std::string key = member.name();
            const Trail here{&trail, key, 0};
            if (const Property* property = schema.find(key)) {
                sound = check(*member, property->schema, here) && sound;
            } else if (schema.mapped) {
                sound = checkName(key, *member, *schema.propertyNames) && sound;
                sound = check(*member, *schema.mapped, here) && sound;
            } else {
                refuseKey(key, *member, value, schema);  // the known keys may still make a sound object
            }
        }
        for (const Property& property : schema.properties) {
            if (!property.required || value.isMember(property.name)) continue;
            sound = report(blamed(value, value), fmt::format("missing key \"{}\"; add {}", property.name,
                                                             expectation(property.schema)));
        }
        return sound;
    }

    // Where a problem of an object's keys belongs: to the override of its "type", if that decided what the
    // keys should be, else to the place in the file.
    static std::ptrdiff_t blamed(const Json::Value& object, const Json::Value& place) {
        const Json::Value& type = object["type"];
        return isOverride(type.getOffsetStart()) ? type.getOffsetStart() : place.getOffsetStart();
    }

    void refuseKey(const std::string& key, const Json::Value& member, const Json::Value& object,
                   const Schema& schema) {
        const std::ptrdiff_t offset = blamed(object, member);
        const std::string lead = schema.title + " may have";
        report(
            isOverride(offset) ? offset : keyOffset(offset),
            fmt::format("unknown key {}; {}", inQuotes(key), suggestion(key, schema.propertyList(), lead)));
    }

    bool checkName(const std::string& name, const Json::Value& member, const Schema& schema) {
        if (schema.pattern && !std::regex_match(name, *schema.pattern)) {
            return report(keyOffset(member.getOffsetStart()),
                          fmt::format("{} is not {}", inQuotes(name), expectation(schema)));
        }
        if (name.size() >= schema.minLength) return true;
        return report(keyOffset(member.getOffsetStart()),
                      fmt::format("\"\" is not {}; write at least one letter", schema.title));
    }

    std::ptrdiff_t keyOffset(std::ptrdiff_t value) const {
        const auto place = std::lower_bound(keys_.begin(), keys_.end(), value,
                                            [](const KeyPlace& a, std::ptrdiff_t b) { return a.value < b; });
        return place != keys_.end() && place->value == value ? place->key : value;
    }

    bool checkArray(const Json::Value& value, const Schema& schema, const Trail& trail) {
        if (value.size() < schema.minItems || (schema.maxItems && value.size() > *schema.maxItems)) {
            return report(value.getOffsetStart(),
                          fmt::format("{} has {} element{}; write {}", trail.subject(), value.size(),
                                      value.size() == 1 ? "" : "s", expectation(schema)));
        }
        bool sound = true;
        Json::ArrayIndex index = 0;
        for (const Json::Value& element : value) {  // value[index] would search: jsoncpp's arrays are maps
            sound = check(element, *schema.items, Trail{&trail, {}, index++}) && sound;
        }
        return sound;
    }

    bool checkText(const Json::Value& value, const Schema& schema, const Trail& trail) {
        if (value.asString().size() >= schema.minLength) return true;
        return report(value.getOffsetStart(), fmt::format("{} is empty; write {}, or leave the key out",
                                                          trail.subject(), expectation(schema)));
    }

    bool checkQuantity(const Json::Value& value, const Schema& schema, const Trail& trail) {
        const std::string text = value.asString();
        const auto refuse = [&](const std::string& why) {
            return report(value.getOffsetStart(),
                          fmt::format("{} is {}{}", trail.subject(), inQuotes(text), why));
        };
        const std::vector<std::string> units = unitsOf(*schema.unit);
        const std::optional<QuantityText> parts = splitQuantity(text);
        if (!parts) return refuse(fmt::format("; write {} (units: {})", expectation(schema), anyOf(units)));
        if (parts->unit.empty()) {
            return refuse(
                fmt::format(", without a unit; write {} (units: {})", expectation(schema), anyOf(units)));
        }
        const std::optional<double> unit = unitInSi(parts->unit, *schema.unit);
        if (!unit) {
            return refuse(fmt::format(", but {} is not a unit of {}; write {}", inQuotes(parts->unit),
                                      nameOf(*schema.unit), anyOf(units)));
        }
        return checkRange(parts->number * *unit, value, schema, trail);
    }

    bool checkRange(double number, const Json::Value& value, const Schema& schema, const Trail& trail) {
        const std::optional<Bound>& lower = schema.lower;
        const std::optional<Bound>& upper = schema.upper;
        const bool tooLow = lower && (lower->exclusive ? number <= lower->value : number < lower->value);
        const bool tooHigh = upper && (upper->exclusive ? number >= upper->value : number > upper->value);
        if (!tooLow && !tooHigh) return true;
        std::string message =
            fmt::format("{} is {}; write {}", trail.subject(), spoken(value), expectationInRange(schema));
        if (upper && std::abs(number) > upper->value && !schema.maximumReason.empty()) {
            message += fmt::format(" ({})", schema.maximumReason);
        }
        if (!schema.rangeReason.empty()) message += fmt::format(" ({})", schema.rangeReason);
        return report(value.getOffsetStart(), std::move(message));
    }

    const std::vector<KeyPlace>& keys_;
    Findings& findings_;
};

}  // namespace

Unsound validate(const Json::Value& root, const Schema& schema, const std::vector<KeyPlace>& keys,
                 Findings& findings) {
    Validator validator(keys, findings);
    validator.check(root, schema, Trail{nullptr, {}, 0});
    return std::move(validator.unsound);
}

}  // namespace fringe::scene
