#include "compile/wave_tables.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "compile/number.hpp"
#include "compile/slit_bins.hpp"

namespace fringe::compile {
namespace {

constexpr double kFirst_um = 1e-3 * optics::kShortestVisible_nm;
constexpr double kRange_um = 1e-3 * (optics::kLongestVisible_nm - optics::kShortestVisible_nm);

device::ResponseEntry ofFloats(double x, double y, double z, double w) {
    const auto bits = [](double value) { return std::bit_cast<device::uint>(toFloat(value)); };
    return {{bits(x), bits(y), bits(z)}, bits(w)};
}

}  // namespace

SlitResponse orderResponse(const LitSlits& lit, const optics::Spectrum& spectrum,
                           const SpectralTables& tables) {
    constexpr double kStep_um = kRange_um / (kOrderEntries - 1);
    constexpr auto kLast = static_cast<std::size_t>(kOrderEntries - 1);
    const std::vector<WavelengthBin> bins = wavelengthBins(lit, spectrum, tables, 1e3 * kStep_um);
    const ResponseRows rows = tables.responseRows();
    std::vector<glm::vec3> density(rows.all() * kOrderEntries);
    for (std::size_t i = 0; i < bins.size(); ++i) {
        const WavelengthBin& bin = bins[i];
        const double perStep = i == 0 || i == kLast ? 2.0 : 1.0;  // the outermost bins are half as wide
        for (std::size_t r = 0; r < bin.colors.size(); ++r) {
            const glm::dvec3 color = perStep * bin.weight / kStep_um * bin.colors[r];
            const auto entry = [&](std::size_t row) -> glm::vec3& {
                return density[(r * rows.perReflectance() + row) * kOrderEntries + i];
            };
            entry(0) = color;
            if (!rows.inBands) continue;
            entry(1 + bin.share.band) = (1.0 - bin.share.upper) * color;
            entry(2 + bin.share.band) = bin.share.upper * color;
        }
    }
    // The place of wavelength 0, so many entries before the first.
    const auto zero = static_cast<device::uint>(-std::lround(kFirst_um / kStep_um));
    SlitResponse out{zero, 1.0 / kStep_um, kOrderEntries, 0.0, 0.0, {}};
    encode(density, out);

    // Behind each table its first moment.
    std::vector<device::ResponseEntry> values;
    for (std::size_t first = 0; first < density.size(); first += kOrderEntries) {
        glm::dvec3 moment(0.0);
        for (std::size_t i = 0; i < kOrderEntries; ++i) {
            const double wavelength_um = kFirst_um + static_cast<double>(i) * kStep_um;
            moment += kStep_um * wavelength_um * glm::dvec3(density[first + i]);
            values.push_back(out.values[first + i]);
        }
        values.push_back(ofFloats(moment.x, moment.y, moment.z, 0.0));
    }
    out.values = std::move(values);
    return out;
}

std::vector<device::ResponseEntry> waveList(const LitSlits& lit, const optics::Spectrum& spectrum,
                                            const SpectralTables& tables, device::uint count) {
    const std::size_t reflectances = tables.reflectances().size();
    const double step_um = kRange_um / (count - 1.0);
    std::vector<glm::dvec3> colors(reflectances * count, glm::dvec3(0.0));
    for (const WavelengthBin& bin : wavelengthBins(lit, spectrum, tables, 0.5)) {
        const double place = (bin.wavelength_um - kFirst_um) / step_um;
        const auto i = std::min(static_cast<std::size_t>(place), std::size_t{count} - 2);
        const double next = place - static_cast<double>(i);
        for (std::size_t r = 0; r < reflectances; ++r) {
            colors[r * count + i] += (1.0 - next) * bin.weight * bin.colors[r];
            colors[r * count + i + 1] += next * bin.weight * bin.colors[r];
        }
    }
    std::vector<device::ResponseEntry> list;
    const auto wavelength_um = [&](std::size_t i) { return kFirst_um + static_cast<double>(i) * step_um; };
    for (std::size_t i = 0; i < count; ++i) {
        const double period = lit.slits.period / units::um / wavelength_um(i);
        const BandShare share = bandShare(1e3 * wavelength_um(i));
        list.push_back(ofFloats(period, period - toFloat(period),
                                lit.slits.width / units::um / wavelength_um(i), share.band + share.upper));
    }
    for (std::size_t r = 0; r < reflectances; ++r) {
        for (std::size_t i = 0; i < count; ++i) {
            const double peak = lit.slits.count * (lit.slits.width / units::um) / wavelength_um(i);
            const glm::dvec3 color = peak * colors[r * count + i];
            list.push_back(ofFloats(color.x, color.y, color.z, 0.0));
        }
    }
    return list;
}

}  // namespace fringe::compile
