#include "compile/evaluators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "compile/gratings.hpp"
#include "compile/wave_tables.hpp"
#include "optics/color.hpp"

namespace fringe::compile {
namespace {

using units::um;

constexpr double kMostTableBytes = 64.0 * 1024.0 * 1024.0;
constexpr device::uint kFewestWaves = 3, kMostWaves = 401;

// What the slits and the direction of the beam say about all ways.
struct Slits {
    double count;
    double period_um;
    double width_um;
    double extent_um;  // from the first slit's outer edge to the last one's
    bool isWide;
    double conical;   // sine of the angle between the beam and the slits
    double largestU;  // change of the direction cosine
    ResponseRows rows;
    bool hasGivenOrders;
    double missed;  // by a table, of the highest value, if they are wide
};

// Steps of a wide slits' table per micrometre of the period: 0.7 nm in the first order.
constexpr double kStepsPerPeriod = 1400.0;

// What a table of wide slits in so many steps misses of a spectrum's highest value: with steps of that
// wavelength in the first order, the largest distance of the recorded spectrum from its chords, of which a
// quarter was found to remain (docs/benchmarks.md): spectra that are measured in coarse steps have knots, and
// a chord across one cuts it off.
double missedBySteps(const optics::Spectrum& spectrum) {
    constexpr double kRemaining = 0.23;
    constexpr double kHalf_nm = 0.5e3 / kStepsPerPeriod;
    constexpr int kCount = 801;  // half nanometres: the tabulated knots are among them
    const auto recorded = [&](double wavelength_nm) {
        return optics::valueAt(spectrum.density, wavelength_nm) * optics::colorMatching(wavelength_nm);
    };
    double highest = 0.0, missed = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double wavelength_nm = optics::kShortestVisible_nm + 0.5 * i;
        const glm::dvec3 here = recorded(wavelength_nm);
        const glm::dvec3 off =
            glm::abs(here - 0.5 * (recorded(wavelength_nm - kHalf_nm) + recorded(wavelength_nm + kHalf_nm)));
        highest = std::max({highest, here.x, here.y, here.z});
        if (i > 0 && i < kCount - 1) missed = std::max({missed, off.x, off.y, off.z});
    }
    return highest > 0.0 ? kRemaining * missed / highest : 0.0;
}

Slits slitsOf(const scene::Grating& grating, const optics::Slits& slits, const optics::Spectrum& spectrum,
              ResponseRows rows) {
    const double period_um = slits.count > 1 ? slits.period / um : slits.width / um;
    const glm::dvec2 incoming = incomingCosines(grating);
    const double conical = std::sqrt(1.0 - incoming.y * incoming.y);
    return {.count = 1.0 * slits.count,
            .period_um = period_um,
            .width_um = slits.width / um,
            .extent_um = (slits.count - 1.0) * period_um + slits.width / um,
            .isWide = areWide(slits),
            .conical = conical,
            .largestU = conical + std::abs(incoming.x),
            .rows = rows,
            .hasGivenOrders = !grating.efficiencies.empty(),
            .missed = areWide(slits) ? missedBySteps(spectrum) : 0.0};
}

std::string mebibytes(double bytes) {
    return fmt::format("{:.3g} MiB", bytes / (1024.0 * 1024.0));
}

// ---- tables --------------------------------------------------------------------------------------

// Steps that keep a part of the tolerance; the rest is for what is not the table's: the beam's edges, the
// undeviated light, colours between bands. Of narrow slits the fringes decide: 113 per micrometre of the
// extent are for 2.5e-4 of the peak, and the error goes as 1/steps^2. Of wide ones it is the spectrum's
// knots, whose error goes as 1/steps.
double wantedSteps(const Slits& slits, double tolerance) {
    double steps = 113.0 * slits.extent_um * std::sqrt(1e-3 / tolerance);
    if (slits.isWide) {
        // Whole multiples, so that knots at every fifth nanometre coincide with entries, in all orders; fewer
        // where building them would take seconds.
        const double usual = kStepsPerPeriod * slits.period_um;
        const double most = std::clamp(std::floor(65'536.0 / usual), 1.0, 4.0);
        steps = usual * std::clamp(std::ceil(2.0 * slits.missed / tolerance), 1.0, most);
    }
    return std::max(64.0, steps);
}

double tableError(const Slits& slits, double steps) {
    if (slits.isWide) return slits.missed * kStepsPerPeriod * slits.period_um / steps;
    const double usual = 113.0 * slits.extent_um;
    return 2.5e-4 * usual * usual / (steps * steps);
}

double tableBytes(const Slits& slits, double steps) {
    return (2.0 * slits.conical * steps + 3.0) * static_cast<double>(slits.rows.all()) *
           sizeof(device::ResponseEntry);
}

// As fine as the tolerance asks for, or as fits.
EvaluatorChoice table(const Slits& slits, double tolerance) {
    const double wanted = wantedSteps(slits, tolerance);
    const double most = kMostTableBytes / tableBytes(slits, wanted) * wanted;
    const double steps = std::min(wanted, most);
    return {.evaluator = device::TABLE_EVALUATOR,
            .stepsPerU = steps,
            .error = tableError(slits, steps),
            .cost = 1.0,
            .bytes = static_cast<std::uint64_t>(tableBytes(slits, steps)),
            .reason = "a look-up"};
}

// ---- orders --------------------------------------------------------------------------------------

// What the side lobes of the orders carry from one to the next is 3/count of the peak at most; between half
// nanometres the spectrum is taken as straight (docs/theory.md, "Evaluators").
EvaluatorChoice orders(const Slits& slits) {
    constexpr double kCostOfOrder =
        3.0;  // in look-ups: as many turns of a loop as the neighbour with most needs
    const double perPoint = 0.5 * slits.largestU * slits.period_um *
                            (1.0 / double{device::FIRST_WAVE_um} - 1.0 / double{device::LAST_WAVE_um});
    return {
        .evaluator = device::ORDERS_EVALUATOR,
        .error = 1e-4 + 3.0 / slits.count,
        .cost = kCostOfOrder * (1.0 + perPoint),
        .bytes = static_cast<std::uint64_t>(kOrderEntries) * slits.rows.all() * sizeof(device::ResponseEntry),
        .reason = fmt::format("orders as lines, {:.2g} at a point", 1.0 + perPoint)};
}

// ---- sums over wavelengths -----------------------------------------------------------------------

// Fringes that the whole extent has between one end of the visible range and the other, at the largest angle.
double fringes(const Slits& slits) {
    return std::max(slits.extent_um, slits.period_um) * slits.largestU *
           (1.0 / double{device::FIRST_WAVE_um} - 1.0 / double{device::LAST_WAVE_um});
}

// A sum resolves fringes two steps wide and more; then it errs as the square of a step's share of a fringe,
// and no less than it does for one narrow slit, whose pattern has the width of the colour-matching functions.
double sumError(const Slits& slits, double waves) {
    const double perWave = fringes(slits) / waves;
    if (perWave > 0.5) return 1.0;
    return 0.05 * perWave * perWave + 0.2 / (waves * waves);
}

device::uint wavesFor(const Slits& slits, double tolerance) {
    device::uint waves = kFewestWaves;
    while (waves < kMostWaves && sumError(slits, waves) > tolerance) ++waves;
    return waves;
}

// Of a list of waves, with a colour for each reflectance.
std::uint64_t listBytes(const Slits& slits, device::uint waves) {
    return (1 + slits.rows.reflectances) * waves * sizeof(device::ResponseEntry);
}

EvaluatorChoice sum(const Slits& slits, std::optional<std::uint32_t> given, device::uint evaluator,
                    double tolerance) {
    constexpr double kCostOfWave = 0.35;  // in look-ups
    const device::uint waves = given ? *given : wavesFor(slits, tolerance);
    return {.evaluator = evaluator,
            .wavelengths = waves,
            .error = sumError(slits, waves),
            .cost = kCostOfWave * waves,
            .bytes = listBytes(slits, waves),
            .reason = fmt::format("a sum over {} wavelengths", waves)};
}

// ---- pairs of slits ------------------------------------------------------------------------------

// Whether these are a few coarse slits, evenly lit, near whose far field the room ends: with more or finer
// ones, or from further away, orders as images of the beam err by less than a fifth of
// count period^2 / (wavelength distance), 1e-3 for half a micrometre at 1 m (docs/theory.md, "Few coarse
// slits").
bool areCoarse(const scene::Grating& grating, const optics::Slits& slits) {
    constexpr std::uint32_t kMostSlits = 32;
    constexpr double kCoarse_m2 = 2.5e-9;
    constexpr double kEven = 0.03;  // of the beam: the light then varies by 2e-3 across the slits
    if (slits.count < 2 || slits.count > kMostSlits || !areWide(slits) || !grating.efficiencies.empty())
        return false;
    const double period = slits.period.si, extent = slits.count * period;
    const bool isRectangle = grating.beam.profile == scene::BeamProfile::rectangle;
    return slits.count * period * period > kCoarse_m2 &&
           extent < (isRectangle ? 1.0 : kEven) * grating.beam.width.si;
}

EvaluatorChoice pairs(const Slits& slits) {
    // Three lobes of a slit are 3 reach turns of the most unlike ways, which from one to the next of 201
    // waves are less than half a turn at 0.38 um up to a reach of 30.
    // The fewer slits have it, the more of the light shows what is beyond.
    const double apart = slits.period_um / slits.width_um, reach = (slits.count - 1.0) * apart;
    const device::uint waves = apart > 60.0 ? 801 : reach > 30.0 ? 401 : 201;
    constexpr double kCostOfHarmonic = 0.3;  // in look-ups
    return {.evaluator = device::PAIRS_EVALUATOR,
            .wavelengths = waves,
            .error = 1e-3,
            .cost = kCostOfHarmonic * waves * slits.count,
            .bytes = listBytes(slits, waves),
            .reason = "coarse slits, pair by pair: a room is within their near field"};
}

// ---- the choice ----------------------------------------------------------------------------------

EvaluatorChoice cheapest(const Slits& slits, const scene::Grating& grating, double tolerance) {
    const EvaluatorChoice tabulated = table(slits, tolerance);
    const double wanted = tableBytes(slits, wantedSteps(slits, tolerance));
    std::vector<EvaluatorChoice> candidates;
    if (tabulated.error <= tolerance) candidates.push_back(tabulated);
    if (!slits.hasGivenOrders) {
        for (const EvaluatorChoice& other :
             {orders(slits), sum(slits, grating.wavelengths, device::DIRECT_EVALUATOR, tolerance)})
            if (other.error <= tolerance) candidates.push_back(other);
    }
    const auto best = std::min_element(candidates.begin(), candidates.end(),
                                       [](const auto& a, const auto& b) { return a.cost < b.cost; });
    std::string noTable;
    if (tabulated.error > tolerance) {
        noTable = wanted > kMostTableBytes
                      ? fmt::format("; a table for the tolerance would take {}", mebibytes(wanted))
                      : "; a table misses more of so sharp a spectrum";
    }
    EvaluatorChoice choice = best == candidates.end() ? tabulated : *best;
    choice.reason +=
        noTable + (best == candidates.end() ? ", and no other way keeps it: this one is the nearest"
                                            : ", the cheapest within the tolerance");
    return choice;
}

}  // namespace

bool areWide(const optics::Slits& slits) {
    constexpr double kWide_um = 40.0;
    return 1.0 * slits.count * (slits.count > 1 ? slits.period / um : slits.width / um) > kWide_um;
}

EvaluatorChoice chooseEvaluator(const scene::Grating& grating, const optics::Slits& given,
                                const optics::Spectrum& spectrum, ResponseRows rows, double tolerance) {
    const Slits slits = slitsOf(grating, given, spectrum, rows);
    EvaluatorChoice choice{};
    switch (grating.evaluator) {
        case scene::Evaluator::automatic:
            return areCoarse(grating, given) ? pairs(slits) : cheapest(slits, grating, tolerance);
        case scene::Evaluator::table:
            choice = table(slits, tolerance);
            break;
        case scene::Evaluator::orders:
            choice = orders(slits);
            break;
        case scene::Evaluator::direct:
            choice = sum(slits, grating.wavelengths, device::DIRECT_EVALUATOR, tolerance);
            break;
        case scene::Evaluator::smallAngle:
            choice = sum(slits, grating.wavelengths, device::SMALL_ANGLE_EVALUATOR, tolerance);
            choice.error = 1.0;  // wrong by any amount at large angles
            break;
        case scene::Evaluator::naive:
            choice = sum(slits, grating.wavelengths, device::NAIVE_EVALUATOR, tolerance);
            choice.error = 1.0;  // next to an order of many slits by more than the peak
            break;
    }
    choice.reason += ", as the scene asks for";
    return choice;
}

const char* nameOf(device::uint evaluator) {
    static constexpr std::array kNames{"table", "orders", "direct", "small-angle", "naive", "pairs"};
    return kNames.at(evaluator);
}

}  // namespace fringe::compile
