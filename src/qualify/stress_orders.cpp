// Orders of the track of an optical disc: where their light comes from, whether they propagate, and the share
// that each takes. Inputs lie where such code breaks: next to grazing, from periods with no order but 0 to
// some with hundreds.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "oracle/fresnel.hpp"
#include "qualify/cases.hpp"
#include "shaders/stress_orders.comp.h"

namespace fringe::qualify {
namespace {

using Inputs = std::span<const float>;

constexpr int kOrders = 6;

constexpr double kPits = 0.25;  // of the area

// Order, pitch, depth and index of the cover, wavelength in um, the eye's cosines, and the pits' width.
void drawTrack(Draw& draw, std::span<float> inputs) {
    const double wavelength = draw.between(0.38, 0.78), pitch = draw.magnitude(0.1, 100.0);
    const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
    // To the eye: anywhere, and often all but along the disc.
    const double sine = draw.oneIn(4) ? 1.0 - draw.magnitude(1e-6, 0.1) : std::sqrt(draw.unit());
    const double order = draw.sign() * (1.0 + draw.below(kOrders));
    double outX = sine * std::cos(angle), outY = sine * std::sin(angle);
    if (draw.oneIn(8)) outX = outY = draw.among<3>({0.0, -0.0, 1e-40});
    // Light that comes all but along the disc.
    if (draw.oneIn(4)) {
        const double across =
            draw.sign() * std::sqrt(std::max(1.0 - outY * outY - draw.magnitude(1e-6, 0.1), 0.0));
        const double most = std::sqrt(1.0 - 1e-6 - outY * outY);
        outX = std::clamp(order * wavelength / pitch - across, -most, most);
    }
    inputs[0] = static_cast<float>(order);
    inputs[1] = static_cast<float>(pitch);
    inputs[2] = static_cast<float>(draw.magnitude(0.01, 0.5));
    inputs[3] = static_cast<float>(draw.oneIn(4) ? 1.0001 : draw.between(1.3, 1.7));
    inputs[4] = static_cast<float>(wavelength);
    inputs[5] = static_cast<float>(outX);
    inputs[6] = static_cast<float>(outY);
    inputs[7] = static_cast<float>(pitch * draw.between(kPits, 0.95));
}

class Track {
public:
    explicit Track(Inputs in) : in_(in), step_(double{in[4]} / in[1]) {}

    // Cosines of the direction that comes with a change by `order` steps, across the track; the eye's is
    // order 0.
    double across(int order) const { return order * step_ - in_[5]; }
    // What an order takes at a contrast of 1.
    double strength(int order) const {
        const double turns = order * (double{in_[7]} / in_[1]);
        return std::pow(kPits * std::sin(std::numbers::pi * turns) / (std::numbers::pi * turns), 2);
    }
    double sineSquared(double across) const { return across * across + double{in_[6]} * in_[6]; }

    // |exp(i phase) - 1|^2 for the way into a pit and back, under these directions outside.
    double contrast(double sineSquared1, double sineSquared2) const {
        const double sine =
            std::sin(std::numbers::pi * in_[2] / in_[4] * (inside(sineSquared1) + inside(sineSquared2)));
        return 4.0 * sine * sine;
    }

private:
    double inside(double sineSquared) const {
        return std::sqrt(std::max(1.0 - sineSquared / (double{in_[3]} * in_[3]), 0.0));
    }

    Inputs in_;
    double step_;
};

// Whether an order propagates cannot be said of those within the rounding of their sine.
bool isUndecided(double sineSquared) {
    return std::abs(sineSquared - 1.0) < 4e-6;
}

Judgement judgeShare(Inputs in, Inputs results, bool isCoarse) {
    const Track track(in);
    const int order = static_cast<int>(in[0]);
    const double incoming = track.sineSquared(track.across(order)), outgoing = track.sineSquared(in[5]);
    if (isUndecided(incoming) || isUndecided(outgoing)) return compared(results[0], results[0]);
    if (incoming > 1.0) return compared(results[0], 0.0);
    double share = track.strength(order) * track.contrast(incoming, outgoing);
    if (!isCoarse) {
        // Shares of what propagates, of light that comes from there, add up to 1.
        double sum = 1.0 - kPits * (1.0 - kPits) * track.contrast(incoming, incoming);
        for (int k = 1; k <= kOrders; ++k) {
            for (const int side : {-1, 1}) {
                const double other =
                    track.sineSquared(track.across(order) + side * k * double{in[4]} / in[1]);
                if (isUndecided(other)) return compared(results[0], results[0]);
                if (other < 1.0) sum += track.strength(k) * track.contrast(incoming, other);
            }
        }
        share /= sum;
    }
    const double cosIn = std::sqrt(1.0 - incoming), cosOut = std::sqrt(std::max(1.0 - outgoing, 0.0));
    return compared(results[0], share * oracle::reflectance(0.5 * (cosIn + cosOut), double{in[3]}));
}

Judgement judgeFine(Inputs inputs, Inputs results) {
    return judgeShare(inputs, results, false);
}
Judgement judgeCoarse(Inputs inputs, Inputs results) {
    return judgeShare(inputs, results, true);
}

}  // namespace

std::vector<StressCase> orderCases() {
    const std::span<const std::uint32_t> shader(stress_orders_comp);
    const std::vector<std::string_view> track{"order",      "pitch", "depth", "index",
                                              "wavelength", "out_x", "out_y", "pit_width"};
    constexpr std::string_view kGrazing =
        "a cosine is the root of 1 less a sine's square, 2e-7 off: 1e-4 at the least that is told from 0, "
        "times what "
        "Fresnel's equations make of it, and a share of 0.25";
    return {
        {"disc-order", "orderShare of a fine track, disc.glsl", 1e-3, kGrazing, shader, 0, track, 1,
         drawTrack, judgeFine, kFullCount},
        {"coarse-disc-order", "orderShare of a coarse track, disc.glsl", 1e-3, kGrazing, shader, 1, track, 1,
         drawTrack, judgeCoarse, kFullCount},
    };
}

}  // namespace fringe::qualify
