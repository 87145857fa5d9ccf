#include "image/icc.hpp"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <new>
#include <string>

namespace fringe::image {

namespace {

using Profile = std::unique_ptr<void, cmsBool (*)(cmsHPROFILE)>;
using Curve = std::unique_ptr<cmsToneCurve, void (*)(cmsToneCurve*)>;

template <class Handle>
Handle required(Handle handle) {
    if (!handle) throw std::bad_alloc();  // the only way in which making one can fail
    return handle;
}

// Parametric curve 4 of ICC.1: (a x + b)^g from d on, c x below, from encoded to linear.
Curve curveOf(ColorSpace space) {
    constexpr double alpha = kRec2020Alpha, beta = kRec2020Beta;
    constexpr std::array srgb{2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045};
    constexpr std::array rec2020{1.0 / 0.45, 1.0 / alpha, (alpha - 1.0) / alpha, 1.0 / 4.5, 4.5 * beta};
    const auto& parameters = space == ColorSpace::rec2020 ? rec2020 : srgb;
    return required(Curve(cmsBuildParametricToneCurve(nullptr, 4, parameters.data()), cmsFreeToneCurve));
}

Profile profileOf(ColorSpace space, const Curve& curve) {
    const cmsCIExyY white{kStandardWhite.x, kStandardWhite.y, 1.0};
    const auto [red, green, blue] = primaries(space);
    const cmsCIExyYTRIPLE corners{{red.x, red.y, 1.0}, {green.x, green.y, 1.0}, {blue.x, blue.y, 1.0}};
    const std::array curves{curve.get(), curve.get(), curve.get()};
    return required(Profile(cmsCreateRGBProfile(&white, &corners, curves.data()), cmsCloseProfile));
}

void describe(const Profile& profile, cmsTagSignature tag, const char* text) {
    const std::unique_ptr<cmsMLU, void (*)(cmsMLU*)> words(required(cmsMLUalloc(nullptr, 1)), cmsMLUfree);
    cmsMLUsetASCII(words.get(), "en", "US", text);
    cmsWriteTag(profile.get(), tag, words.get());
}

}  // namespace

const char* nameOf(ColorSpace space) {
    switch (space) {
        case ColorSpace::srgb:
            return "sRGB";
        case ColorSpace::displayP3:
            return "Display P3";
        case ColorSpace::rec2020:
            return "Rec. 2020";
    }
    assert(false);
    return "";
}

std::vector<std::uint8_t> iccProfile(ColorSpace space) {
    const Profile profile = profileOf(space, curveOf(space));
    describe(profile, cmsSigProfileDescriptionTag, nameOf(space));
    describe(profile, cmsSigCopyrightTag, "No copyright, use freely");
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile.get(), nullptr, &size);
    std::vector<std::uint8_t> bytes(size);
    if (size == 0 || cmsSaveProfileToMem(profile.get(), bytes.data(), &size) == 0) throw std::bad_alloc();

    // Little CMS stamps the header with the time of day; a fixed day, 2015-01-01, keeps files reproducible.
    constexpr std::size_t kDateAt = 24;
    constexpr std::array<std::uint8_t, 12> date{0x07, 0xDF, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};
    std::copy(date.begin(), date.end(), bytes.begin() + kDateAt);
    return bytes;
}

std::optional<IccDecoder> IccDecoder::create(std::span<const std::uint8_t> profile) {
    const Profile encoded(cmsOpenProfileFromMem(profile.data(), static_cast<cmsUInt32Number>(profile.size())),
                          cmsCloseProfile);
    if (!encoded || cmsGetColorSpace(encoded.get()) != cmsSigRgbData) return {};
    const Curve identity = required(Curve(cmsBuildGamma(nullptr, 1.0), cmsFreeToneCurve));
    const Profile linear = profileOf(ColorSpace::srgb, identity);
    // Floats on both sides and no optimisation: the steps are taken one by one, and nothing is clipped.
    Transform transform(
        cmsCreateTransform(encoded.get(), TYPE_RGB_FLT, linear.get(), TYPE_RGB_FLT,
                           INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE),
        cmsDeleteTransform);
    if (!transform) return {};
    return IccDecoder(std::move(transform));
}

void IccDecoder::decode(std::span<float> rgb) const {
    assert(rgb.size() % 3 == 0);
    cmsDoTransform(transform_.get(), rgb.data(), rgb.data(), static_cast<cmsUInt32Number>(rgb.size() / 3));
}

}  // namespace fringe::image
