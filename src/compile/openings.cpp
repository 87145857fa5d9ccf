#include "compile/openings.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "compile/beam_profile.hpp"
#include "compile/gratings.hpp"
#include "compile/near_field.hpp"
#include "compile/near_layers.hpp"
#include "compile/number.hpp"
#include "compile/opening_tables.hpp"
#include "compile/uneven_lattice.hpp"
#include "optics/integrals.hpp"
#include "optics/quadrature.hpp"
#include "optics/transform.hpp"

namespace fringe::compile {
namespace {

using namespace units;
using glm::dvec2;
using optics::kLongestVisible_nm, optics::kShortestVisible_nm;

// ---- shapes --------------------------------------------------------------------------------------

// Whether every vertex has another one opposite, to 1e-6 of the size.
bool hasCentre(const optics::PolygonalAperture& polygon) {
    const std::size_t count = polygon.vertices.size();
    if (count % 2 != 0) return false;
    const double tolerance = 1e-6 * openingExtent(polygon);
    for (std::size_t i = 0; i < count / 2; ++i) {
        if (glm::length(polygon.vertices[i] + polygon.vertices[i + count / 2]) > tolerance) return false;
    }
    return true;
}

device::vec4 highAndLow(dvec2 value) {
    const device::vec2 high(value);
    const dvec2 low = value - dvec2(high);
    return {high.x, high.y, toFloat(low.x), toFloat(low.y)};
}

// Fills in what of the record describes an opening, or a lattice's cell.
struct OpeningPacker {
    device::OpeningGrating& packed;
    std::vector<float>& values;

    void operator()(const optics::RectangularAperture& rectangle) const {
        packed.opening = device::RECTANGULAR_OPENING;
        packed.size_um = {toFloat(rectangle.width / um), toFloat(rectangle.height / um)};
    }
    void operator()(const optics::CircularAperture& circle) const {
        const double inner = circle.innerDiameter / circle.diameter;
        packed.opening = inner > 0.0 ? device::RING_OPENING : device::CIRCULAR_OPENING;
        packed.size_um = {toFloat(circle.diameter / um), toFloat(inner)};
    }
    void operator()(const optics::PolygonalAperture& polygon) const {
        const std::size_t edges = polygon.vertices.size();
        const bool isSymmetric = hasCentre(polygon) && edges <= std::size_t{2} * device::FEW_EDGES;
        packed.opening = isSymmetric ? device::SYMMETRIC_OPENING : device::POLYGONAL_OPENING;
        packed.size_um = {toFloat(1e12 * optics::area(polygon)), 0.0F};
        packed.extent = toFloat(1e6 * openingExtent(polygon));
        packed.table = count(values.size());
        packed.edgeCount = count(isSymmetric ? edges / 2 : edges);
        for (const dvec2& vertex : polygon.vertices) {
            values.push_back(toFloat(1e6 * vertex.x));
            values.push_back(toFloat(1e6 * vertex.y));
        }
    }
    void operator()(const optics::LatticeAperture& lattice) const {
        std::visit(*this, lattice.cell);
        packed.isLattice = 1;
        packed.first_um = highAndLow(1e6 * lattice.first);
        packed.second_um = highAndLow(1e6 * lattice.second);
        packed.counts = {toFloat(lattice.firstCount), toFloat(lattice.secondCount)};
    }
    // Slits have a record of their own; a mask is its table.
    void operator()(const optics::Slits&) const {}
    void operator()(const optics::MaskAperture&) const {}
};

// Sums over a lattice's cells of the amplitudes that a beam gives them, and of their squares.
struct CellSums {
    double sum;
    double squares;
};

// The part of the record that says how a Gaussian beam lights them. `tables`: null where the sums have closed
// forms, the integrals over a beam that is wide beside a cell.
CellSums packCells(const optics::LatticeAperture& lattice, double beamWidth, const MaskTables* tables,
                   device::OpeningGrating& packed, std::vector<float>& values) {
    const LitCells lit = litCells(lattice, beamWidth).value();
    const double area = std::abs(lattice.first.x * lattice.second.y - lattice.first.y * lattice.second.x);
    const double whole = 0.25 * std::numbers::pi * beamWidth * beamWidth / area;
    CellSums cells{whole, 0.5 * whole};
    packed.isUneven = 1;
    packed.beamRadius_um = toFloat(0.5e6 * beamWidth);
    packed.counts = {toFloat(lit.firstCount), toFloat(lit.secondCount)};
    if (tables != nullptr) {
        cells = {std::sqrt(tables->spectrum.peak()), tables->spectrum.area()};
        packed.cells = count(values.size());
        packed.cellsSize = {toFloat(tables->spectrum.columns()), toFloat(tables->spectrum.rows())};
        values.insert(values.end(), tables->levels.begin(), tables->levels.end());
        // As a row would have it that is even and varies as much: it ends an eighth beyond the first zero.
        const dvec2 variance = cellVariance(cellAmplitudes(lattice, beamWidth, lit));
        const dvec2 steps(glm::length(lattice.first), glm::length(lattice.second));
        packed.cellsWidth = device::vec2(glm::sqrt(12.0 * variance) / 1.125);
        packed.cellsFollow = device::vec2(8.0 * variance * steps * steps / (beamWidth * beamWidth));
    }
    packed.imagePeak = toFloat(std::pow(whole / cells.sum, 2));
    return cells;
}

// `mask`: null where the opening's far field is not looked up.
void packLayers(const NearLayers& layers, const MaskTables* mask, device::OpeningGrating& packed,
                std::vector<float>& values) {
    packed.hasLayers = 1;
    packed.layers = count(values.size());
    device::LayerRow row = layers.row;
    if (mask != nullptr) {
        constexpr double kAlong = 0.9999;
        for (const optics::Edge& edge : mask->spectrum.edges()) {
            float& sum = std::abs(edge.normal.x) > kAlong   ? row.upright
                         : std::abs(edge.normal.y) > kAlong ? row.level
                                                            : row.slanting;
            sum += toFloat(1e-18 * edge.weight / mask->spectrum.peak());
        }
    }
    for (const float value : {row.count, row.entries, row.points, row.across, row.pixel_um, row.half_um,
                              row.first, row.ratio, row.upright, row.level, row.slanting})
        values.push_back(value);
    values.insert(values.end(), layers.values.begin(), layers.values.end());
}

// From which on it is taken, at 550 nm: the far field is off by 3e-4 of its peak there at 380 nm.
constexpr double kLeastFresnelNumber = 0.012;

// ---- spectrum ------------------------------------------------------------------------------------

// A wavelength: its wavenumber per um, and for each reflectance its colour.
struct Wave {
    double wavenumber;
    std::vector<glm::dvec3> colors;
};

struct SpectrumPacker {
    double factor;  // |A(0)|^2 / area times the power
    OpeningShares& shares;
    const SpectralTables& tables;

    // What the device is to multiply by the relative pattern.
    glm::dvec3 color(double wavelength_nm, double power) const {
        const double wavelength = 1e-9 * wavelength_nm;
        return factor * power / (wavelength * wavelength * shares.at(wavelength_nm)) *
               tables.response(0, wavelength_nm);
    }

    // The continuous spectrum on even steps of the wavenumber, where fringes are even. The colours are such
    // that the sum is exact for every pattern that is a polynomial of the third degree over four neighbouring
    // steps.
    std::vector<Wave> continuum(const optics::Curve& density, const std::vector<double>& wavenumbers) const {
        const std::vector<optics::Curve>& reflectances = tables.reflectances();
        std::vector<Wave> waves;
        for (const double wavenumber : wavenumbers)
            waves.push_back({wavenumber, std::vector<glm::dvec3>(reflectances.size(), glm::dvec3(0.0))});
        const double first = wavenumbers.front();
        const double step = wavenumbers[1] - first;
        const double last = static_cast<double>(wavenumbers.size()) - 4.0;
        for (std::size_t row = 0; row < reflectances.size(); ++row) {
            for (const optics::Node& node : optics::densityNodes(density, reflectances[row])) {
                const glm::dvec3 value = color(node.wavelength_nm, node.weight);
                const double place = (1e3 / node.wavelength_nm - first) / step;
                const double from = std::clamp(std::floor(place) - 1.0, 0.0, last);
                for (int i = 0; i < 4; ++i) {
                    double weight = 1.0;  // Lagrange's polynomial
                    for (int j = 0; j < 4; ++j)
                        if (j != i) weight *= (place - from - j) / (i - j);
                    waves[static_cast<std::size_t>(from) + static_cast<std::size_t>(i)].colors[row] +=
                        weight * value;
                }
            }
        }
        return waves;
    }

    Wave line(const SpectralSample& sample) const {
        Wave wave{1e3 / sample.wavelength_nm, {}};
        for (const optics::Curve& reflectance : tables.reflectances()) {
            wave.colors.push_back(optics::valueAt(reflectance, sample.wavelength_nm) *
                                  color(sample.wavelength_nm, sample.power));
        }
        return wave;
    }
};

// Sixteen wavelengths give a single opening to 1e-4 of its peak, a tenth of the usual tolerance; the error
// goes as the inverse of their square. Twice as many do so also where metals on the way have their own say,
// and the orders of a lattice take their number in step with the cells in a row (docs/theory.md, "Openings").
// Beyond the most the device merges cells. Light from the rim of a near field and light from the middle turn
// against each other by half the Fresnel number; a step is a fifth of such a turn.
std::size_t waveCount(double extentInCells, double fresnelNumber, bool inBands, double tolerance) {
    constexpr double kMost = 256.0, kMostNear = 128.0;
    const double fewest = std::max(8.0, std::round((inBands ? 32.0 : 16.0) * std::sqrt(1e-3 / tolerance)));
    const double near = std::max(fewest, std::min(fewest + std::ceil(1.9 * fresnelNumber), kMostNear));
    return static_cast<std::size_t>(std::clamp(std::ceil(1.5 * extentInCells), std::min(near, kMost), kMost));
}

std::vector<double> evenWavenumbers(std::size_t count) {
    constexpr double kFirst_per_um = 1e3 / kLongestVisible_nm, kLast_per_um = 1e3 / kShortestVisible_nm;
    const double step = (kLast_per_um - kFirst_per_um) / static_cast<double>(count - 1);
    std::vector<double> wavenumbers;
    for (std::size_t i = 0; i < count; ++i)
        wavenumbers.push_back(kFirst_per_um + step * static_cast<double>(i));
    return wavenumbers;
}

// Where on the source light comes from, as direction cosines off its middle, by Gauss's rule.
struct SourcePoint {
    dvec2 direction;
    double weight;
};

std::vector<SourcePoint> sourcePoints(double size, int across) {
    if (size == 0.0) return {{dvec2(0.0), 1.0}};
    std::vector<SourcePoint> points;
    const optics::GaussRule rule = optics::gaussLegendre(across);
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        for (std::size_t j = 0; j < rule.weights.size(); ++j) {
            points.push_back(
                {0.5 * size * dvec2(rule.nodes[i], rule.nodes[j]), 0.25 * rule.weights[i] * rule.weights[j]});
        }
    }
    return points;
}

// Each wave from each point: wavenumbers and directions, then the colours, row by row.
void appendSamples(const std::vector<Wave>& waves, const std::vector<SourcePoint>& points,
                   std::vector<float>& values) {
    for (const Wave& wave : waves) {
        for (const SourcePoint& point : points) {
            for (const double value : {wave.wavenumber, point.direction.x, point.direction.y})
                values.push_back(toFloat(value));
        }
    }
    const std::size_t rows = waves.empty() ? 0 : waves.front().colors.size();
    for (std::size_t row = 0; row < rows; ++row) {
        for (const Wave& wave : waves) {
            for (const SourcePoint& point : points) {
                for (int i = 0; i < 3; ++i) values.push_back(toFloat(point.weight * wave.colors[row][i]));
            }
        }
    }
}

}  // namespace

device::OpeningGrating compileOpening(const scene::Grating& grating, const optics::Spectrum& spectrum,
                                      const SpectralTables& tables, double tolerance,
                                      const NearestField& nearest, std::size_t mostLayers,
                                      std::vector<float>& values) {
    const scene::Beam& beam = grating.beam;
    const dvec2 incoming = incomingCosines(grating);

    device::OpeningGrating packed{};
    packed.position = glm::vec3(grating.position);
    packed.across = glm::vec3(glm::cross(grating.slitDirection, grating.normal));
    packed.along = glm::vec3(grating.slitDirection);
    packed.normal = glm::vec3(grating.normal);
    packed.incoming = device::vec2(incoming);
    packed.convergence = beam.focus ? toFloat(1.0 / (*beam.focus / m)) : 0.0F;

    // The opening, and what its pattern needs.
    const optics::Aperture& aperture = grating.aperture;
    const double fresnelNumber = nearest.fresnelNumber;
    const std::optional<UnevenBeam> profile = profileAcross(grating, fresnelNumber);
    const OpeningTables shape = openingTables(aperture, profile, incoming, tables.memo());
    const double cellExtent = openingExtent(aperture);
    double area = 0.0, peak = 0.0;
    if (shape.mask) {
        const optics::MaskSpectrum& maskSpectrum = shape.mask->spectrum;
        area = maskSpectrum.area();
        peak = maskSpectrum.peak();
        packed.opening = device::MASK_OPENING;
        packed.size_um = {toFloat(maskSpectrum.columns()), toFloat(maskSpectrum.rows())};
        packed.pixel_um = device::vec2(1e6 * maskSpectrum.pixel());
        packed.extent = toFloat(maskSpectrum.pixelsAcross());
        packed.hasHats = maskSpectrum.hasHats() ? 1U : 0U;
        packed.table = count(values.size());
        values.insert(values.end(), shape.mask->levels.begin(), shape.mask->levels.end());
    } else if (profile && profile->isWhole) {
        packed.opening = device::GAUSSIAN_OPENING;
        packed.beamRadius_um = toFloat(0.5e6 * profile->width);
        const double whole = 0.25 * std::numbers::pi * profile->width * profile->width;
        area = 0.5 * whole;
        peak = whole * whole;
    } else {
        area = optics::area(aperture);
        peak = area * area;
        std::visit(OpeningPacker{packed, values}, aperture);
        if (const auto* lattice = std::get_if<optics::LatticeAperture>(&aperture);
            lattice != nullptr && profile) {
            const CellSums cells = packCells(*lattice, profile->width, shape.cells.get(), packed, values);
            const double cell = optics::moments(lattice->cell).area;
            area = cell * cells.squares;
            peak = std::pow(cell * cells.sum, 2);
        }
    }
    assert(std::isfinite(cellExtent));
    packed.isNear = packed.opening <= device::RING_OPENING && hasNearField(aperture) &&
                            fresnelNumber > kLeastFresnelNumber
                        ? 1U
                        : 0U;

    double turns = packed.isNear != 0 ? fresnelNumber : 0.0;
    if (hasNearLayers(aperture, profile, fresnelNumber)) {
        constexpr double kMostFollowed = 12.0;  // layers are means over steps of the wavelength beyond
        turns = std::min(fresnelNumber, kMostFollowed);
        const auto layers = nearLayers(grating, profile, nearest, spectrum, mostLayers, tables.memo());
        packLayers(*layers, shape.mask.get(), packed, values);
    }

    if (!spectrum.density.empty()) shape.shares->findAll();
    const SpectrumPacker packer{beam.power / W * leavingShare(grating) * peak / area, *shape.shares, tables};

    // A source so wide that it hides the fringes between the cells is seen as points further apart than
    // these.
    constexpr double kFewestFringes = 6.0;
    const double size = beam.angularSize / rad;
    const double shortest = kShortestVisible_nm * 1e-9;
    const double fringes = size * wholeExtent(aperture) / shortest;
    const double resolved =
        fringes <= kFewestFringes ? fringes : std::min(size * cellExtent / shortest, kFewestFringes);
    // Gauss's rule, to 1e-4. In a near field the device averages over the source.
    const int pointsAcross = turns > 0.0 ? 1 : 2 + static_cast<int>(std::ceil(2.5 * resolved));
    packed.sourceBlur = toFloat(size / pointsAcross);
    const std::vector<SourcePoint> points = sourcePoints(size, pointsAcross);

    std::vector<Wave> waves;
    if (!spectrum.density.empty()) {
        const std::vector<double> wavenumbers = evenWavenumbers(
            waveCount(wholeExtent(aperture) / cellExtent, turns, tables.bands() > 1, tolerance));
        packed.wavenumberStep = toFloat(wavenumbers[1] - wavenumbers[0]);
        waves = packer.continuum(spectrum.density, wavenumbers);
    }
    for (const SpectralSample& line : lineSamples(spectrum)) waves.push_back(packer.line(line));
    packed.sampleCount = count(waves.size() * points.size());
    packed.samples = count(values.size());
    appendSamples(waves, points, values);
    return packed;
}

}  // namespace fringe::compile
