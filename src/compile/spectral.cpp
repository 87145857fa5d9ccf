#include "compile/spectral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compile/metals.hpp"
#include "optics/color.hpp"
#include "optics/quadrature.hpp"
#include "optics/sources.hpp"

namespace fringe::compile {
namespace {

using namespace units;

template <class Element, class Equal>
device::uint rowOf(std::vector<Element>& rows, const Element& element, Equal equal) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Element& row) { return equal(row, element); });
    const auto index = static_cast<device::uint>(found - rows.begin());
    if (found == rows.end()) rows.push_back(element);
    return index;
}

bool sameCurve(const optics::Curve& a, const optics::Curve& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const optics::Knot& p, const optics::Knot& q) {
                          return p.wavelength_nm == q.wavelength_nm && p.value == q.value;
                      });
}

bool sameSpectrum(const optics::Spectrum& a, const optics::Spectrum& b) {
    return sameCurve(a.density, b.density) &&
           std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(),
                      [](const optics::Line& p, const optics::Line& q) {
                          return p.wavelength == q.wavelength && p.power == q.power && p.width == q.width;
                      });
}

}  // namespace

std::vector<SpectralSample> continuousSamples(const optics::Spectrum& spectrum, double step_nm) {
    std::vector<SpectralSample> samples;
    if (spectrum.density.empty()) return samples;
    const int steps =
        static_cast<int>(std::lround((optics::kLongestVisible_nm - optics::kShortestVisible_nm) / step_nm));
    for (int i = 0; i <= steps; ++i) {
        const double wavelength_nm = optics::kShortestVisible_nm + i * step_nm;
        const double weight = i == 0 || i == steps ? 0.5 : 1.0;
        samples.push_back(
            {wavelength_nm, weight * step_nm * optics::valueAt(spectrum.density, wavelength_nm)});
    }
    return samples;
}

std::vector<SpectralSample> lineSamples(const optics::Spectrum& spectrum) {
    // Gauss-Hermite nodes and weights for seven points (Abramowitz & Stegun, table 25.10), weights divided by
    // sqrt(pi).
    constexpr std::array<double, 4> kNodes{0.0, 0.816287882858965, 1.673551628767471, 2.651961356835233};
    constexpr std::array<double, 4> kWeights{0.457142857142857, 0.240123178605013, 0.030757123967586,
                                             0.000548268855972};
    constexpr double kFwhmPerNode =
        0.600561204393225;  // 1 / (2 sqrt(ln 2)): a node of 1 is exp(-1)'s half width
    std::vector<SpectralSample> samples;
    const auto add = [&](double wavelength_nm, double power) {
        if (wavelength_nm >= optics::kShortestVisible_nm && wavelength_nm <= optics::kLongestVisible_nm)
            samples.push_back({wavelength_nm, power});
    };
    for (const optics::Line& line : spectrum.lines) {
        const double center_nm = line.wavelength / nm;
        const double scale_nm = kFwhmPerNode * (line.width / nm);
        if (scale_nm == 0.0) {
            add(center_nm, line.power);
            continue;
        }
        for (std::size_t i = 0; i < kNodes.size(); ++i) {
            add(center_nm + kNodes[i] * scale_nm, line.power * kWeights[i]);
            if (i > 0) add(center_nm - kNodes[i] * scale_nm, line.power * kWeights[i]);
        }
    }
    return samples;
}

double bandMiddle_nm(device::uint band) {
    using namespace device;
    const uint middle = std::clamp(band, LOW_STEPS, LOW_STEPS + MIDDLE_STEPS) - LOW_STEPS;
    const uint low = std::min(band, LOW_STEPS);
    return 1e3 * (double{FIRST_BAND_um} + double{LOW_STEP_um} * low + double{MIDDLE_STEP_um} * middle +
                  double{HIGH_STEP_um} * (band - low - middle));
}

BandShare bandShare(double wavelength_nm) {
    device::uint band = 0;
    while (band + 2 < device::SPECTRAL_BANDS && wavelength_nm >= bandMiddle_nm(band + 1)) ++band;
    const double below = bandMiddle_nm(band), above = bandMiddle_nm(band + 1);
    return {band, std::clamp((wavelength_nm - below) / (above - below), 0.0, 1.0)};
}

SpectralTables::SpectralTables(Measure measure, device::uint bands, TableMemo* memo)
    : measure_(measure),
      bands_(bands),
      bandResponses_(bands > 1),
      memo_(memo),
      perWatt_(optics::kMaximumLuminousEfficacy / optics::luminousEfficacyOfD65()),
      reflectances_{optics::constantCurve(1.0)} {}

device::uint SpectralTables::spectrum(const optics::Spectrum& spectrum) {
    return rowOf(spectra_, spectrum, sameSpectrum);
}

SpectralTables::Reflector SpectralTables::reflector(const optics::Curve& reflectance) {
    if (measure_ == Measure::irradiance || measure_ == Measure::spectrum)
        return {0, static_cast<float>(std::numbers::pi)};
    if (optics::isConstant(reflectance))
        return {0, static_cast<float>(optics::valueAt(reflectance, optics::kShortestVisible_nm))};
    return {rowOf(reflectances_, reflectance, sameCurve), 1.0F};
}

device::uint SpectralTables::metal(scene::Metal metal) {
    return rowOf(metals_, metal, std::equal_to<>());
}

glm::dvec3 SpectralTables::response(std::size_t reflectance, double wavelength_nm) const {
    const glm::dvec3 weight =
        measure_ == Measure::color ? perWatt_ * optics::colorMatching(wavelength_nm) : glm::dvec3(1.0);
    return reflectance == 0 ? weight : weight * optics::valueAt(reflectances_[reflectance], wavelength_nm);
}

std::vector<float> SpectralTables::colors() const {
    std::vector<float> table;
    for (const optics::Spectrum& spectrum : spectra_) {
        for (const optics::Curve& reflectance : reflectances_) {
            std::vector<optics::Node> nodes = optics::densityNodes(spectrum.density, reflectance);
            for (const optics::Line& line : spectrum.lines) {
                const std::vector<optics::Node> more = optics::lineNodes(line, reflectance);
                nodes.insert(nodes.end(), more.begin(), more.end());
            }
            std::vector<glm::dvec3> colors(bands_ == 1 ? 1 : bands_ + 1, glm::dvec3(0.0));
            for (const optics::Node& node : nodes) {
                const glm::dvec3 color = node.weight * response(0, node.wavelength_nm);
                colors[0] += color;
                if (bands_ == 1) continue;
                const auto [band, upper] = bandShare(node.wavelength_nm);
                colors[band + 1] += (1.0 - upper) * color;
                colors[band + 2] += upper * color;
            }
            for (const glm::dvec3& color : colors) {
                for (int i = 0; i < 3; ++i) table.push_back(static_cast<float>(color[i]));
            }
        }
    }
    return table;
}

std::vector<float> SpectralTables::metalIndices() const {
    std::vector<float> table;
    for (const scene::Metal metal : metals_) {
        const MetalTable indices(metal);
        for (device::uint band = 0; band < bands_; ++band) {
            const std::complex<double> index = indices.at(bandMiddle_nm(band));
            table.push_back(static_cast<float>(index.real()));
            table.push_back(static_cast<float>(index.imag()));
        }
    }
    return table;
}

}  // namespace fringe::compile
