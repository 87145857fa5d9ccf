#include "oracle/thesis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fringe::oracle {
namespace {

using glm::cross;
using glm::dot;
using glm::length;
using scene::Rgb;
using std::numbers::pi;

// Fields of `count` slits, summed one by one about their middle; `phase` is from a slit to the next.
double sumOverSlits(unsigned count, double phase) {
    double sum = 0.0;
    for (unsigned slit = 0; slit < count; ++slit) sum += std::cos((slit - 0.5 * (count - 1.0)) * phase);
    return sum;
}

// Sine of the deviation in the listing's plane of `x` and the normal, from the sizes `a` and `b` of a
// direction's parts along them. x is perpendicular to the normal, so it is a plain quotient.
double limitSine(double a, double b) {
    return a == 0.0 ? 0.0 : a / std::hypot(a, b);
}

// The same by the listing's detour over the cosine, where 1 - cos^2 may round to 0 or below.
double printedSine(double a, const dvec3& x, double b, const dvec3& normal) {
    dvec3 theta = a * x + b * normal;
    theta = theta / length(theta);
    double sintheta = dot(theta, normal) / (length(theta) * length(normal));
    sintheta = std::sqrt(1.0 - sintheta * sintheta);
    return sintheta;
}

Rgb intensity(scene::Faults faults, const scene::Slits& slits, double a, const dvec3& x, double b,
              const dvec3& normal) {
    if (faults == scene::Faults::asPrinted) return printedIntensity(printedSine(a, x, b, normal), slits);
    return limitIntensity(limitSine(a, b), slits);
}

}  // namespace

Rgb limitIntensity(double sine, const scene::Slits& slits) {
    Rgb result;
    for (int channel = 0; channel < 3; ++channel) {
        const double phasePerMetre = 2.0 * pi * sine / kPrintedWavelengths[channel];
        const double halfDelta = 0.5 * phasePerMetre * slits.width.si;
        const double oneSlit = halfDelta == 0.0 ? 1.0 : std::sin(halfDelta) / halfDelta;
        const double amplitude = oneSlit * sumOverSlits(slits.count, phasePerMetre * slits.period.si);
        result[channel] = std::min(amplitude * amplitude, 1.0);
    }
    return result;
}

Rgb printedIntensity(double sine, const scene::Slits& slits) {
    Rgb result;
    for (int channel = 0; channel < 3; ++channel) {
        const double delta = 2 * pi * sine * slits.width.si / kPrintedWavelengths[channel];
        double value = std::sin(delta / 2);
        value = (value * value) / ((delta / 2) * (delta / 2));
        if (slits.count > 1) {
            const double xi = 2 * pi * sine * slits.period.si / kPrintedWavelengths[channel];
            double multiple = std::sin(xi / 2 * slits.count);
            multiple = (multiple * multiple) / (std::sin(xi / 2) * std::sin(xi / 2));
            value *= multiple;
        }
        if (value > 1.0) value = 1.0;  // lets NaN pass, as printed
        result[channel] = value;
    }
    return result;
}

Rgb gratingValue(const scene::ThesisGrating& grating, const dvec3& point) {
    const dvec3 toLight = grating.position - point;
    const double distance = length(toLight);
    if (distance == 0.0) return Rgb(0.0);
    const dvec3 shadowRay = toLight / distance;
    if (!(dot(shadowRay, grating.normal) < 0.0)) return Rgb(0.0);  // behind the grating

    // The beam makes a band along x, as high as it is wide.
    const double radius = 0.5 * grating.beamDiameter.si;
    const double spline = std::abs(dot(toLight, grating.slitDirection));  // "splinedistance"
    if (spline > radius) return Rgb(0.0);
    const double share = spline / radius;
    const double ratio = grating.attenuated ? 1.0 - share * share : 1.0;

    const dvec3 x = cross(grating.normal, grating.slitDirection);
    const double a = std::abs(dot(shadowRay, x));
    const double b = std::abs(dot(shadowRay, grating.normal));
    return ratio * intensity(grating.faults, grating.slits, a, x, b, grating.normal);
}

Rgb discPattern(const scene::ThesisDisc& material, const scene::Disc& disc, const dvec3& point,
                const dvec3& view) {
    const dvec3 axis = point - disc.center;
    const double fromCenter = length(axis);
    const bool hasDirection = fromCenter > 0.0 || material.faults == scene::Faults::asPrinted;
    const dvec3 x = hasDirection ? axis / fromCenter : dvec3(0.0);
    const double a = std::abs(dot(view, x));
    const double b = std::abs(dot(view, disc.normal));
    return intensity(material.faults, material.slits, a, x, b, disc.normal);
}

}  // namespace fringe::oracle
