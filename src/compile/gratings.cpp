#include "compile/gratings.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <variant>

#include "compile/evaluators.hpp"
#include "compile/number.hpp"
#include "compile/slit_shares.hpp"
#include "compile/wave_tables.hpp"
#include "optics/energy.hpp"
#include "optics/orders.hpp"

namespace fringe::compile {
namespace {

using namespace units;

// From this many on, the lines of wide slits are images of the beam, an order each; what the three nearest
// orders leave out of the exact sum is 1 / (pi^2 count^2 1.5) of the peak.
constexpr std::uint32_t kManySlits = 16;

device::uint profileOf(scene::BeamProfile profile) {
    switch (profile) {
        case scene::BeamProfile::flat:
            return device::FLAT_BEAM;
        case scene::BeamProfile::gaussian:
            return device::GAUSSIAN_BEAM;
        case scene::BeamProfile::rectangle:
            return device::RECTANGULAR_BEAM;
    }
    return device::FLAT_BEAM;
}

// Wavelengths that the device follows one by one, for one reflectance: [sample][wavelength_um, x, y, z].
void appendFollowed(const std::vector<SpectralSample>& samples, const std::vector<glm::dvec3>& colors,
                    std::vector<float>& values) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        values.push_back(toFloat(1e-3 * samples[i].wavelength_nm));
        for (int j = 0; j < 3; ++j) values.push_back(toFloat(colors[i][j]));
    }
}

// What of each sample's power propagates when all of it leaves: the power divided by the share that would.
void divideByShares(const LitSlits& lit, std::vector<SpectralSample>& samples) {
    for (SpectralSample& sample : samples) sample.power /= lit.propagatingShare(sample.wavelength_nm);
}

// Share of the beam that an order of the slits takes.
double orderShare(const LitSlits& lit, int order, double wavelength_nm) {
    if (lit.orders.empty()) {
        const double fill = lit.slits.width / lit.slits.period;
        return optics::orderEfficiency(fill, order) / fill;  // of what leaves
    }
    for (const scene::OrderEfficiency& given : lit.orders) {
        if (given.order == order) return optics::valueAt(given.efficiency, wavelength_nm);
    }
    return 0.0;
}

// [line][order], from the lowest order that is given to the highest.
void appendShares(const std::vector<SpectralSample>& lines, const LitSlits& lit, device::SlitGrating& packed,
                  std::vector<float>& values) {
    if (lit.orders.empty() || lines.empty()) return;
    const auto [lowest, highest] = std::minmax_element(
        lit.orders.begin(), lit.orders.end(), [](const auto& a, const auto& b) { return a.order < b.order; });
    packed.shares = static_cast<device::uint>(values.size());
    packed.firstOrder = toFloat(lowest->order);
    packed.orderCount = static_cast<device::uint>(highest->order - lowest->order + 1);
    for (const SpectralSample& line : lines) {
        for (int order = lowest->order; order <= highest->order; ++order)
            values.push_back(toFloat(orderShare(lit, order, line.wavelength_nm)));
    }
}

// [reflectance][line][...]
void appendLines(const std::vector<SpectralSample>& lines, const SpectralTables& tables,
                 std::vector<float>& values) {
    for (std::size_t reflectance = 0; reflectance < tables.reflectances().size(); ++reflectance) {
        std::vector<glm::dvec3> colors;
        for (const SpectralSample& line : lines)
            colors.push_back(line.power * tables.response(reflectance, line.wavelength_nm));
        appendFollowed(lines, colors, values);
    }
}

// A spectrum in coarse steps, for light that all wavelengths share the way of; the colours are those of the
// `fine` samples, divided between the coarse ones on either side. [reflectance][step][...]; returns how many
// steps there are.
device::uint appendCoarse(const std::vector<SpectralSample>& fine, const SpectralTables& tables,
                          std::vector<float>& values) {
    const double step_nm = 1e3 * double{device::ZERO_ORDER_STEP_um};
    std::vector<SpectralSample> coarse;
    for (double at = optics::kShortestVisible_nm; at <= optics::kLongestVisible_nm; at += step_nm)
        coarse.push_back({at, 0.0});
    for (std::size_t reflectance = 0; reflectance < tables.reflectances().size(); ++reflectance) {
        std::vector<glm::dvec3> sums(coarse.size(), glm::dvec3(0.0));
        for (const SpectralSample& sample : fine) {
            const double place = (sample.wavelength_nm - optics::kShortestVisible_nm) / step_nm;
            const auto i = std::min(static_cast<std::size_t>(place), coarse.size() - 2);
            const double next = place - static_cast<double>(i);
            const glm::dvec3 color = sample.power * tables.response(reflectance, sample.wavelength_nm);
            sums[i] += (1.0 - next) * color;
            sums[i + 1] += next * color;
        }
        appendFollowed(coarse, sums, values);
    }
    return static_cast<device::uint>(coarse.size());
}

// What a grating needs beside its record.
void addTables(const LitSlits& lit, const optics::Spectrum& spectrum, const SpectralTables& tables,
               const EvaluatorChoice& choice, device::SlitGrating& packed, std::vector<float>& values,
               ResponseTables& responses) {
    const auto here = [&] { return static_cast<device::uint>(values.size()); };
    if (!spectrum.density.empty()) {
        ResponseTables::Table entries;
        if (choice.wavelengths > 0) {
            entries = std::make_shared<const std::vector<device::ResponseEntry>>(
                waveList(lit, spectrum, tables, choice.wavelengths));
            packed.entries = choice.wavelengths;
        } else {
            const auto kept = choice.evaluator == device::ORDERS_EVALUATOR
                                  ? std::make_shared<const SlitResponse>(orderResponse(lit, spectrum, tables))
                                  : slitResponse(lit, spectrum, tables, packed.isWide == 0, choice.stepsPerU);
            const SlitResponse& response = *kept;
            packed.zeroEntry = response.zeroEntry;
            packed.perU = toFloat(response.perU);
            packed.entries = response.entries;
            packed.integralUnit = toFloat(response.integralUnit);
            packed.slopeUnit = toFloat(response.slopeUnit);
            entries = {kept, &response.values};
        }
        packed.response = count(responses.append(std::move(entries)));
        if (packed.isWide != 0) {
            std::vector<SpectralSample> undeviated = continuousSamples(spectrum, 1.0);
            const auto shares = propagatingShares(lit, 1.0, tables.memo());
            for (std::size_t i = 0; i < undeviated.size(); ++i)
                undeviated[i].power *= orderShare(lit, 0, undeviated[i].wavelength_nm) / (*shares)[i];
            packed.zeroOrder = here();
            packed.zeroOrderCount = appendCoarse(undeviated, tables, values);
        }
    }
    std::vector<SpectralSample> lines = lineSamples(spectrum);
    divideByShares(lit, lines);
    packed.lines = here();
    packed.lineCount = static_cast<device::uint>(lines.size());
    appendLines(lines, tables, values);
    appendShares(lines, lit, packed, values);
}

void shareTables(const device::SlitGrating& from, device::SlitGrating& to) {
    to.zeroEntry = from.zeroEntry;
    to.perU = from.perU;
    to.entries = from.entries;
    to.response = from.response;
    to.integralUnit = from.integralUnit;
    to.slopeUnit = from.slopeUnit;
    to.lines = from.lines;
    to.lineCount = from.lineCount;
    to.shares = from.shares;
    to.orderCount = from.orderCount;
    to.firstOrder = from.firstOrder;
    to.zeroOrder = from.zeroOrder;
    to.zeroOrderCount = from.zeroOrderCount;
}

// A single slit has no period; its width serves.
optics::Slits withPeriod(optics::Slits slits) {
    if (slits.count == 1) slits.period = slits.width;
    return slits;
}

// Where slits are, and the shape of their beam: the part of the record that needs no spectrum.
device::SlitGrating slitBeam(const scene::Grating& grating, const optics::Slits& slits) {
    const scene::Beam& beam = grating.beam;
    const glm::dvec2 incoming = incomingCosines(grating);
    device::SlitGrating packed{};
    packed.position = glm::vec3(grating.position);
    packed.across = glm::vec3(glm::cross(grating.slitDirection, grating.normal));
    packed.along = glm::vec3(grating.slitDirection);
    packed.normal = glm::vec3(grating.normal);
    packed.alphaIn = toFloat(incoming.x);
    packed.betaIn = toFloat(incoming.y);
    packed.profile = profileOf(beam.profile);
    packed.halfWidth = toFloat(0.5 * (beam.width / m));
    packed.halfHeight = toFloat(0.5 * (beam.height / m));
    packed.halfSlits = toFloat(0.5 * (1.0 * slits.count * slits.period / m));
    packed.convergence = beam.focus ? toFloat(1.0 / (*beam.focus / m)) : 0.0F;
    packed.angularSize = toFloat(beam.angularSize / rad);
    packed.count = toFloat(slits.count);
    packed.width_um = toFloat(slits.width / um);
    packed.period_um = toFloat(slits.period / um);
    return packed;
}

// Directions count as the same far below the rounding of a float.
bool isAlike(const LitSlits& a, const LitSlits& b) {
    constexpr double kSame = 1e-10;
    return a.slits == b.slits && a.orders == b.orders && std::abs(a.alphaIn - b.alphaIn) < kSame &&
           std::abs(a.betaIn - b.betaIn) < kSame;
}

}  // namespace

double leavingShare(const scene::Grating& grating) {
    if (grating.efficiency) return *grating.efficiency;
    return optics::openFraction(grating.aperture, grating.beam.width / m, grating.beam.height / m,
                                grating.beam.profile);
}

glm::dvec2 incomingCosines(const scene::Grating& grating) {
    return {glm::dot(grating.beam.direction, glm::cross(grating.slitDirection, grating.normal)),
            glm::dot(grating.beam.direction, grating.slitDirection)};
}

std::vector<device::SlitGrating> continuousBeams(const scene::Scene& scene) {
    std::vector<device::SlitGrating> beams;
    for (const scene::Light& light : scene.lights) {
        const auto* grating = std::get_if<scene::Grating>(&light.model);
        if (grating == nullptr || light.spectrum.density.empty()) continue;
        if (const auto* slits = std::get_if<optics::Slits>(&grating->aperture))
            beams.push_back(slitBeam(*grating, withPeriod(*slits)));
    }
    return beams;
}

device::SlitGrating compileSlits(const scene::Grating& grating, const optics::Slits& given,
                                 const optics::Spectrum& spectrum, const SpectralTables& tables,
                                 double tolerance, std::vector<float>& values, ResponseTables& responses,
                                 std::vector<KnownSlits>& known) {
    const scene::Beam& beam = grating.beam;
    const optics::Slits slits = withPeriod(given);
    const glm::dvec2 incoming = incomingCosines(grating);
    const LitSlits lit{slits, grating.efficiencies, incoming.x, incoming.y};
    const EvaluatorChoice choice =
        chooseEvaluator(grating, slits, spectrum, tables.responseRows(), tolerance);
    const bool byOrders = choice.evaluator == device::ORDERS_EVALUATOR;
    const bool byPairs = choice.evaluator == device::PAIRS_EVALUATOR;
    const bool isWide = areWide(slits) && !byPairs;
    const bool followsUndeviated = isWide || byOrders;

    // Power per area that leaves, averaged over a period; where orders take their shares of it, that arrives.
    double irradiance =
        beam.power / W * optics::centralIrradiance(beam.width / m, beam.height / m, beam.profile);
    if (lit.orders.empty()) irradiance *= slits.width / slits.period;
    if (grating.efficiency) {
        irradiance *=
            *grating.efficiency / optics::openFraction(slits, beam.width / m, beam.height / m, beam.profile);
    }

    device::SlitGrating packed = slitBeam(grating, slits);
    packed.irradiance = toFloat(irradiance);
    packed.isWide = followsUndeviated ? 1U : 0U;
    packed.linesAreImages = (isWide && slits.count >= kManySlits) || !lit.orders.empty() ? 1U : 0U;
    packed.evaluator = choice.evaluator;

    const auto alike = std::find_if(known.begin(), known.end(), [&](const KnownSlits& other) {
        return isAlike(other.lit, lit) && other.spectrum == spectrum &&
               other.packed.evaluator == choice.evaluator && other.wavelengths == choice.wavelengths;
    });
    if (alike != known.end()) {
        shareTables(alike->packed, packed);
    } else {
        addTables(lit, spectrum, tables, choice, packed, values, responses);
        known.push_back({lit, spectrum, choice.wavelengths, packed});
    }
    return packed;
}

}  // namespace fringe::compile
