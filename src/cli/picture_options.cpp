#include "cli/picture_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/input.hpp"
#include "optics/color.hpp"
#include "render/development.hpp"

namespace fringe::cli {
namespace {

struct NamedSpace {
    const char* name;
    scene::ColorSpace ofScene;
};

constexpr std::array kSpaces{
    NamedSpace{"srgb", scene::ColorSpace::srgb},
    NamedSpace{"display-p3", scene::ColorSpace::displayP3},
    NamedSpace{"rec2020", scene::ColorSpace::rec2020},
};

const NamedSpace& spaceOf(const scene::Image& image) {
    return *std::find_if(kSpaces.begin(), kSpaces.end(),
                         [&](const NamedSpace& space) { return space.ofScene == image.colorSpace; });
}

// A whole text that is a number of stops, in the range that scene files have; "+" may stand before it.
std::optional<double> stopsOf(std::string_view text) {
    constexpr double kMost = 64.0;
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double stops = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), stops);
    if (error != std::errc() || end != text.data() + text.size() || !(std::abs(stops) <= kMost)) return {};
    return stops;
}

image::Development developmentOf(const scene::Scene& scene, const PictureOptions& options) {
    auto development = render::developmentOf(scene);
    if (!development) {
        throw InputError(
            "camera.white_balance: this light is too saturated to look white; give the spectrum of a lamp");
    }
    for (const image::NamedToneCurve& named : image::kToneCurves)
        if (named.name == options.toneCurve) development->toneCurve = named.curve;
    return *development;
}

}  // namespace

void addPictureOptions(CLI::App& command, PictureOptions& options) {
    command
        .add_option(
            "--exposure", options.exposure,
            "stops, or auto: from the highlights of the picture; auto+1 is a stop brighter (PNG only)")
        ->option_text("STOPS|auto");
    command
        .add_option("--color-space", options.colorSpace,
                    "of PNG files: srgb, display-p3 or rec2020 (default: the scene's)")
        ->check(CLI::IsMember({"srgb", "display-p3", "rec2020"}));
    std::vector<std::string> curves;
    for (const image::NamedToneCurve& named : image::kToneCurves) curves.emplace_back(named.name);
    command
        .add_option(
            "--tone-curve", options.toneCurve,
            "of PNG files: linear (default), reinhard or filmic, which keep apart what is brighter than "
            "white")
        ->check(CLI::IsMember(curves));
    command
        .add_option("--quantity", options.quantity,
                    "color (default), or in EXR files luminance (cd/m^2), radiance (W/(m^2 sr)) or "
                    "irradiance (W/m^2)")
        ->check(CLI::IsMember({"color", "luminance", "radiance", "irradiance"}));
    command.add_option("--png-bits", options.pngBits, "8 (default) or 16")->check(CLI::IsMember({8, 16}));
    command
        .add_option("--exr-type", options.exrType,
                    "half (default for colours) or float (default for quantities)")
        ->check(CLI::IsMember({"half", "float"}));
    command.add_option("--exr-color", options.exrColor, "rgb (default: linear, Rec. 709) or xyz (CIE 1931)")
        ->check(CLI::IsMember({"rgb", "xyz"}));
}

image::Quantity quantityOf(const PictureOptions& options) {
    constexpr std::array quantities{image::Quantity::color, image::Quantity::luminance,
                                    image::Quantity::radiance, image::Quantity::irradiance};
    return *std::find_if(quantities.begin(), quantities.end(), [&](image::Quantity quantity) {
        return options.quantity == image::nameOf(quantity);
    });
}

void applyTo(scene::Image& image, const PictureOptions& options) {
    for (const NamedSpace& space : kSpaces) {
        if (options.colorSpace == space.name) image.colorSpace = space.ofScene;
    }
    if (options.exposure.empty()) return;
    constexpr std::string_view automatic = "auto";
    std::string_view text = options.exposure;
    image.autoExposure = text.starts_with(automatic);
    if (image.autoExposure) text.remove_prefix(automatic.size());
    const bool isSigned = text.starts_with('+') || text.starts_with('-');
    const std::optional<double> stops = image.autoExposure && text.empty() ? 0.0
                                        : image.autoExposure && !isSigned  ? std::nullopt
                                                                           : stopsOf(text);
    if (!stops) {
        throw InputError(fmt::format(
            "--exposure {}: give stops from -64 to 64, or auto, or auto and stops, as in auto-1.5",
            options.exposure));
    }
    image.exposure = *stops;
}

image::OutputOptions outputOptions(const PictureOptions& options, const scene::Scene& scene) {
    const image::Quantity quantity = quantityOf(options);
    const bool isColor = quantity == image::Quantity::color;
    return {.development = developmentOf(scene, options),
            .pngBits = options.pngBits,
            .quantity = quantity,
            .exrColor = options.exrColor == "xyz" ? image::ExrColor::xyz : image::ExrColor::rgb,
            .whiteLuminance = optics::luminousEfficacyOfD65(),
            .exrFloat = options.exrType.empty() ? !isColor : options.exrType == "float"};
}

std::string pictureText(const PictureOptions& options, const scene::Image& image) {
    std::string text;
    if (image.colorSpace != scene::ColorSpace::srgb)
        text += fmt::format(", color space {}", spaceOf(image).name);
    if (options.toneCurve != "linear") text += fmt::format(", tone curve {}", options.toneCurve);
    if (options.quantity != "color") text += fmt::format(", quantity {}", options.quantity);
    return text;
}

}  // namespace fringe::cli
