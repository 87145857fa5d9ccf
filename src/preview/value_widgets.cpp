#include "preview/value_widgets.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "scene/quantity.hpp"

namespace fringe::preview {
namespace {

using scene::JsonType;
using scene::Schema;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr float kShareOfValue = 0.005F;  // that one pixel of dragging changes
constexpr float kFromZero = 0.01F;       // likewise where the value is 0
constexpr float kMetresPerPixel = 0.005F;
constexpr double kNarrow = 10.0;  // a range whose ends are no further apart, as a factor, gets a slider

std::string rounded(double number, const std::string& unit) {
    return fmt::format("{:.6g} {}", number, unit);
}

float limited(double value) {
    constexpr double kMost = std::numeric_limits<float>::max() / 4;
    return static_cast<float>(std::clamp(value, -kMost, kMost));
}

// In the unit that it is written in.
std::optional<Json::Value> drawQuantity(const Schema& schema, const char* label, const Json::Value& value) {
    const std::string text = value.asString();
    const auto parts = scene::splitQuantity(text);
    if (!parts) return std::nullopt;
    const std::string unit(parts->unit);
    const double si = scene::unitInSi(unit, *schema.unit).value_or(1.0);
    const float least = limited(schema.lower ? schema.lower->value / si : 0.0);  // few may be negative
    const float most = limited(schema.upper ? schema.upper->value / si : 1e30);
    const std::string format = "%.5g " + unit;
    auto number = static_cast<float>(parts->number);
    const bool isNarrow = schema.lower && schema.upper && schema.lower->value >= 0.0 &&
                          schema.upper->value <= kNarrow * std::max(schema.lower->value, 1e-300);
    const bool isAngle = schema.unit == scene::Dimension::angle && schema.upper;
    const bool changed =
        isNarrow || isAngle
            ? ImGui::SliderFloat(label, &number, least, most, format.c_str(), ImGuiSliderFlags_AlwaysClamp)
            : ImGui::DragFloat(label, &number, number != 0.0F ? kShareOfValue * std::abs(number) : kFromZero,
                               least, most, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    if (!changed) return std::nullopt;
    return Json::Value(rounded(double{number}, unit));
}

std::optional<Json::Value> drawNumber(const Schema& schema, const char* label, const Json::Value& value) {
    auto number = static_cast<float>(value.asDouble());
    const float least = limited(schema.lower ? schema.lower->value : -1e30);
    const float most = limited(schema.upper ? schema.upper->value : 1e30);
    const bool isShare = schema.lower && schema.upper && schema.upper->value <= kNarrow;
    const bool changed =
        isShare
            ? ImGui::SliderFloat(label, &number, least, most, "%.4g", ImGuiSliderFlags_AlwaysClamp)
            : ImGui::DragFloat(label, &number, std::max(kMetresPerPixel, kShareOfValue * std::abs(number)),
                               least, most, "%.4g", ImGuiSliderFlags_AlwaysClamp);
    if (!changed) return std::nullopt;
    // As many digits as were meant: 0.1, and not the nearest float in double precision.
    return Json::Value(std::stod(fmt::format("{:.6g}", number)));
}

std::optional<Json::Value> drawInteger(const Schema& schema, const char* label, const Json::Value& value) {
    const auto bound = [](const std::optional<scene::Bound>& bound, int otherwise) {
        return bound ? static_cast<int>(std::clamp(bound->value, -2e9, 2e9)) : otherwise;
    };
    int number = static_cast<int>(std::min<double>(value.asDouble(), 2e9));
    if (!ImGui::InputInt(label, &number)) return std::nullopt;
    return Json::Value(
        std::clamp(number, bound(schema.lower, -2'000'000'000), bound(schema.upper, 2'000'000'000)));
}

std::optional<Json::Value> drawChoice(const Schema& schema, const char* label, const Json::Value& value) {
    std::optional<Json::Value> chosen;
    if (!ImGui::BeginCombo(label, value.asString().c_str())) return chosen;
    for (const Json::Value& choice : schema.choices)
        if (ImGui::Selectable(choice.asString().c_str(), choice == value)) chosen = choice;
    ImGui::EndCombo();
    return chosen;
}

// A direction by two angles: around the vertical from +z on, and above the horizon.
std::optional<Json::Value> drawDirection(const char* label, const Json::Value& value) {
    const double x = value[0].asDouble(), y = value[1].asDouble(), z = value[2].asDouble();
    std::array angles{static_cast<float>(std::atan2(x, z) / kDegree),
                      static_cast<float>(std::atan2(y, std::hypot(x, z)) / kDegree)};
    // Without limits: a turn goes on beyond the half one.
    if (!ImGui::DragFloat2(label, angles.data(), 0.25F, 0.0F, 0.0F, "%.1f deg")) return std::nullopt;
    const double around = double{angles[0]} * kDegree;
    const double above = std::clamp(double{angles[1]}, -90.0, 90.0) * kDegree;
    Json::Value turned(Json::arrayValue);
    for (const double part :
         {std::sin(around) * std::cos(above), std::sin(above), std::cos(around) * std::cos(above)})
        turned.append(std::round(part * 1e6) / 1e6);
    return turned;
}

std::optional<Json::Value> drawVector(const Schema& schema, const char* label, const Json::Value& value) {
    std::array<float, 4> numbers{};
    const auto count = static_cast<int>(std::min<std::size_t>(value.size(), numbers.size()));
    for (int i = 0; i < count; ++i) numbers.at(static_cast<std::size_t>(i)) = value[i].asFloat();
    const bool isColor = schema.title.find("colour") != std::string::npos;
    const bool changed = isColor ? ImGui::ColorEdit3(label, numbers.data(),
                                                     ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR)
                                 : ImGui::DragScalarN(label, ImGuiDataType_Float, numbers.data(), count,
                                                      kMetresPerPixel, nullptr, nullptr, "%.3f");
    if (!changed) return std::nullopt;
    Json::Value changedValue(Json::arrayValue);
    for (int i = 0; i < count; ++i)
        changedValue.append(std::stod(fmt::format("{:.6g}", numbers.at(static_cast<std::size_t>(i)))));
    return changedValue;
}

// A name, taken when Enter is pressed.
std::optional<Json::Value> drawText(const char* label, const Json::Value& value) {
    std::array<char, 1024> text{};
    value.asString().copy(text.data(), text.size() - 1);
    if (!ImGui::InputText(label, text.data(), text.size(), ImGuiInputTextFlags_EnterReturnsTrue))
        return std::nullopt;
    return Json::Value(text.data());
}

bool isVector(const Schema& schema) {
    return schema.type == JsonType::array && schema.items != nullptr &&
           schema.items->type == JsonType::number && schema.maxItems && *schema.maxItems <= 4;
}

}  // namespace

bool isSimple(const Schema& schema) {
    if (!schema.alternatives.empty()) return false;
    return isVector(schema) || (schema.type != JsonType::object && schema.type != JsonType::array);
}

bool isDirection(const Schema& schema) {
    return isVector(schema) && schema.title.find("direction") != std::string::npos;
}

std::optional<Json::Value> drawValue(const Schema& schema, const char* label, const Json::Value& value) {
    if (schema.unit) return drawQuantity(schema, label, value);
    if (!schema.choices.empty() && value.isString()) return drawChoice(schema, label, value);
    if (isVector(schema)) {
        return isDirection(schema) && value.size() == 3 ? drawDirection(label, value)
                                                        : drawVector(schema, label, value);
    }
    if (value.isBool()) {
        bool flag = value.asBool();
        if (ImGui::Checkbox(label, &flag)) return Json::Value(flag);
        return std::nullopt;
    }
    if (schema.type == JsonType::integer) return drawInteger(schema, label, value);
    if (value.isNumeric()) return drawNumber(schema, label, value);
    if (value.isString()) return drawText(label, value);
    return std::nullopt;
}

}  // namespace fringe::preview
