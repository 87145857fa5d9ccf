#include "qualify/evaluator_cases.hpp"

#include <vector>

#include "compile/evaluators.hpp"
#include "compile/interface.hpp"
#include "optics/sources.hpp"
#include "units/units.hpp"

namespace fringe::qualify {

std::span<const EvaluatorCase> evaluatorCases() {
    static const std::vector<EvaluatorCase> cases = [] {
        const optics::Spectrum d65 = *optics::namedSpectrum("D65"), diode = *optics::namedSpectrum("LED-B3"),
                               sodium = *optics::namedSpectrum("sodium"),
                               laser = optics::laser(632.8 * units::nm, {});
        return std::vector<EvaluatorCase>{
            {"1 slit of 1 um, D65", 1, 1.0, 1.0, d65, 0.95},
            {"1 slit of 20 um, D65", 1, 20.0, 20.0, d65, 0.95},
            {"2 slits of 1/2 um, D65", 2, 1.0, 2.0, d65, 0.95},
            {"5 slits of 1/2 um, D65", 5, 1.0, 2.0, d65, 0.95},
            {"5 slits of 1/2 um, D65, to 3 deg", 5, 1.0, 2.0, d65, 0.052},
            {"5 slits of 20/100 um, D65", 5, 20.0, 100.0, d65, 0.95},
            {"2 slits of 50/500 um in a wide beam, D65", 2, 50.0, 500.0, d65, 0.052, 0.0, true},
            {"2 slits of 5/500 um in a wide beam, D65", 2, 5.0, 500.0, d65, 0.3, 0.0, true},
            {"50 slits of 0.8/1.6 um, D65", 50, 0.8, 1.6, d65, 0.95},
            {"50 slits of 50/100 um, D65", 50, 50.0, 100.0, d65, 0.95},
            {"1000 slits of 0.8/1.6 um, D65", 1000, 0.8, 1.6, d65, 0.95},
            {"1000 slits of 50/100 um, D65", 1000, 50.0, 100.0, d65, 0.95},
            {"10^4 slits of 0.8/1.6 um, D65", 10'000, 0.8, 1.6, d65, 0.95},
            {"10^6 slits of 0.16/0.32 um at 58 deg, D65", 1'000'000, 0.16, 0.32, d65, 0.95, 0.85},
            {"10^6 slits of 0.8/1.6 um, D65", 1'000'000, 0.8, 1.6, d65, 0.95},
            {"5 slits of 1/2 um, white diode", 5, 1.0, 2.0, diode, 0.95},
            {"1000 slits of 0.8/1.6 um, white diode", 1000, 0.8, 1.6, diode, 0.95},
            {"5 slits of 1/2 um, laser", 5, 1.0, 2.0, laser, 0.95},
            {"1000 slits of 0.8/1.6 um, laser", 1000, 0.8, 1.6, laser, 0.95},
            {"5 slits of 1/2 um, sodium", 5, 1.0, 2.0, sodium, 0.95},
            {"1000 slits of 0.8/1.6 um, sodium", 1000, 0.8, 1.6, sodium, 0.95},
        };
    }();
    return cases;
}

optics::Slits slitsOf(const EvaluatorCase& which) {
    return {which.count, which.width_um * units::um, which.period_um * units::um};
}

bool hasContinuum(const EvaluatorCase& which) {
    return !which.spectrum.density.empty();
}

double undeviatedUpTo(const EvaluatorCase& which) {
    if (!hasContinuum(which) || which.isWidelyLit || !compile::areWide(slitsOf(which))) return 0.0;
    const double extent_um = (which.count - 1.0) * which.period_um + which.width_um;
    return double{device::ZERO_ORDER_LOBES} * double{device::LAST_WAVE_um} / extent_um;
}

}  // namespace fringe::qualify
