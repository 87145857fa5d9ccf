#include "scene/extract_spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>
#include <span>
#include <utility>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "optics/spectrum.hpp"
#include "scene/files.hpp"

namespace fringe::scene {
namespace {

using optics::Curve;
using optics::Spectrum;

// What the sum of efficiencies rounded to six digits may exceed 1 by.
constexpr double kRounding = 1e-6;

std::optional<Spectrum> lineSpectrumOf(const Node& node) {
    const Node lines = node["lines"];
    const units::Length width = node["linewidth"].length();
    Spectrum spectrum;
    for (const Node& line : lines.elements())
        spectrum.lines.push_back({line["wavelength"].length(), line["power"].number(), width});
    if (optics::visiblePower(spectrum) > 0.0) return optics::normalised(std::move(spectrum));
    lines.refuse("all lines have the power 0; give one of them more");
    return std::nullopt;
}

std::optional<Spectrum> spectrumOfFile(const Node& file) {
    std::optional<Curve> density = curveOf(file);
    if (!density) return std::nullopt;
    Spectrum spectrum{std::move(*density), {}};
    if (optics::visiblePower(spectrum) > 0.0) return optics::normalised(std::move(spectrum));
    file.refuse(
        fmt::format("{} is 0 from 380 nm to 780 nm; write a file with some visible light", pathText(file)));
    return std::nullopt;
}

// Holds one visible watt.
std::optional<Spectrum> anySpectrumOf(const Node& node);

std::optional<Spectrum> sumOf(const Node& node) {
    std::vector<optics::WeightedSpectrum> parts;
    double weights = 0.0;
    bool sound = true;
    for (const Node& part : node["parts"].elements()) {
        const double weight = part["weight"].number();
        std::optional<Spectrum> spectrum = anySpectrumOf(part["spectrum"]);
        sound = sound && spectrum;
        weights += weight;
        if (spectrum) parts.push_back({weight, std::move(*spectrum)});
    }
    if (!sound) return std::nullopt;
    if (weights > 0.0) return optics::normalised(optics::weightedSum(parts));
    node["parts"].refuse("all parts have the weight 0; give one of them more");
    return std::nullopt;
}

std::optional<Spectrum> anySpectrumOf(const Node& node) {
    if (node.isText()) {
        std::optional<Spectrum> named = optics::namedSpectrum(node.text());
        assert(named);
        return named;
    }
    const std::string type = node["type"].text();
    if (type == "laser") return optics::laser(node["wavelength"].length(), node["linewidth"].length());
    if (type == "blackbody") return optics::planck(node["temperature"].temperature().si);
    if (type == "led") return optics::led(node["wavelength"].length(), node["width"].length());
    if (type == "lines") return lineSpectrumOf(node);
    if (type == "csv") return spectrumOfFile(node["file"]);
    assert(type == "sum");
    return sumOf(node);
}

// Both ends of a measured curve go on as they are (CIE 15:2018, 7.2.3, recommends the nearest value).
Curve overTheVisible(Curve curve) {
    const optics::Knot first = curve.front();
    const optics::Knot last = curve.back();
    if (first.wavelength_nm > optics::kShortestVisible_nm)
        curve.insert(curve.begin(), {optics::kShortestVisible_nm, first.value});
    if (last.wavelength_nm < optics::kLongestVisible_nm)
        curve.push_back({optics::kLongestVisible_nm, last.value});
    return curve;
}

// False, with a problem recorded, where a value is above 1.
bool areShares(const Node& file, const Curve& curve) {
    for (const optics::Knot& knot : curve) {
        if (knot.value <= 1.0) continue;
        file.refuse(fmt::format("{} has the value {} at {} nm; write values from 0 to 1", pathText(file),
                                knot.value, knot.wavelength_nm));
        return false;
    }
    return true;
}

Curve curveOfFile(const Node& file) {
    std::optional<Curve> curve = curveOf(file);
    if (!curve || !areShares(file, *curve)) return optics::constantCurve(0.0);
    return overTheVisible(std::move(*curve));
}

Curve curveOfTable(const Node& node) {
    const std::vector<Node> wavelengths = node["wavelengths"].elements();
    const std::vector<Node> values = node["values"].elements();
    if (wavelengths.size() != values.size()) {
        node["values"].refuse(fmt::format("there are {} values for {} wavelengths; write as many",
                                          values.size(), wavelengths.size()),
                              {node["wavelengths"]});
        return optics::constantCurve(0.0);
    }
    Curve curve;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double wavelength_nm = wavelengths[i].length() / units::nm;
        if (!curve.empty() && wavelength_nm <= curve.back().wavelength_nm) {
            wavelengths[i].refuse(
                fmt::format(
                    "the wavelength \"{}\" is not above the one before it, \"{}\"; write them ascending",
                    wavelengths[i].text(), wavelengths[i - 1].text()),
                {wavelengths[i - 1]});
            return optics::constantCurve(0.0);
        }
        curve.push_back({wavelength_nm, values[i].number()});
    }
    return overTheVisible(std::move(curve));
}

// Between the knots of all curves their sum is linear, so its maximum is at one of them.
void requireConservation(const Node& node, std::span<const OrderEfficiency> orders) {
    for (const OrderEfficiency& of : orders) {
        for (const optics::Knot& knot : of.efficiency) {
            if (knot.wavelength_nm < optics::kShortestVisible_nm) continue;
            if (knot.wavelength_nm > optics::kLongestVisible_nm) break;
            double sum = 0.0;
            for (const OrderEfficiency& other : orders)
                sum += optics::valueAt(other.efficiency, knot.wavelength_nm);
            if (sum <= 1.0 + kRounding) continue;
            node.refuse(fmt::format("the orders together get {:.6g} of the light at {} nm; write at most 1",
                                    sum, knot.wavelength_nm));
            return;
        }
    }
}

int orderNamed(std::string_view name) {
    int order = 0;
    std::from_chars(name.data(), name.data() + name.size(), order);
    return order;
}

}  // namespace

Spectrum spectrumOf(const Node& node, units::Length linewidth) {
    std::optional<Spectrum> spectrum = anySpectrumOf(node);
    if (!spectrum) return {};
    if (linewidth.si == 0.0) return std::move(*spectrum);
    for (optics::Line& line : spectrum->lines) {
        if (line.width.si == 0.0) line.width = linewidth;
    }
    return optics::normalised(std::move(*spectrum));  // a line at the end of the visible range has lost some
}

Spectrum tinted(const Spectrum& spectrum, const Node& color) {
    const dvec3 rgb = color.vector();
    return rgb == dvec3(1.0) ? spectrum : optics::filtered(spectrum, optics::reflectanceCurve(rgb));
}

Curve shareOf(const Node& node) {
    if (node.isNumber()) return optics::constantCurve(node.number());
    if (node.isArray()) return optics::reflectanceCurve(node.vector());
    if (node["type"].text() == "csv") return curveOfFile(node["file"]);
    assert(node["type"].text() == "table");
    return curveOfTable(node);
}

std::vector<OrderEfficiency> efficienciesOf(const Node& node) {
    std::vector<OrderEfficiency> orders;
    const std::vector<Node> entries = node.entries();
    if (node.has("file")) {
        const Node file = node["file"];
        if (!entries.empty()) {
            file.refuse("\"file\" stands beside single orders; keep one or the other", {entries.front()});
            return {};
        }
        for (OrderEfficiency& of : orderCurvesOf(file).value_or(std::vector<OrderEfficiency>{})) {
            if (!areShares(file, of.efficiency)) return {};
            orders.push_back({of.order, overTheVisible(std::move(of.efficiency))});
        }
    } else if (entries.empty()) {
        node.refuse(fmt::format(
            "\"{}\" has no order; write one, such as {{\"1\": 0.3}}, or leave the key out", node.key()));
    }
    for (const Node& entry : entries) orders.push_back({orderNamed(entry.key()), shareOf(entry)});
    std::sort(orders.begin(), orders.end(),
              [](const OrderEfficiency& a, const OrderEfficiency& b) { return a.order < b.order; });
    requireConservation(node, orders);
    return orders;
}

}  // namespace fringe::scene
