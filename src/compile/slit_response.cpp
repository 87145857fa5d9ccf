#include "compile/slit_response.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>

#include "compile/order_integrals.hpp"
#include "compile/parallel.hpp"
#include "compile/slit_bins.hpp"
#include "compile/slit_shares.hpp"
#include "compile/table_memo.hpp"
#include "optics/energy.hpp"
#include "optics/integrals.hpp"

namespace fringe::compile {

std::vector<WavelengthBin> wavelengthBins(const LitSlits& lit, const optics::Spectrum& spectrum,
                                          const SpectralTables& tables, double step_nm) {
    const auto shares = propagatingShares(lit, step_nm, tables.memo());
    std::vector<WavelengthBin> bins;
    for (const SpectralSample& sample : continuousSamples(spectrum, step_nm)) {
        WavelengthBin bin{};
        bin.wavelength_um = 1e-3 * sample.wavelength_nm;
        bin.weight = sample.power / (*shares)[bins.size()];
        for (std::size_t r = 0; r < tables.reflectances().size(); ++r) {
            bin.colors.push_back(tables.response(r, sample.wavelength_nm));
        }
        for (const scene::OrderEfficiency& order : lit.orders) {
            bin.orders.push_back(optics::valueAt(order.efficiency, sample.wavelength_nm));
        }
        bin.share = bandShare(sample.wavelength_nm);
        bins.push_back(std::move(bin));
    }
    return bins;
}

namespace {

// One colour for each table.
class Accumulator {
public:
    explicit Accumulator(ResponseRows rows) : rows_(rows), sums_(rows.all(), glm::dvec3(0.0)) {}

    void add(const WavelengthBin& bin, double value) {
        for (std::size_t r = 0; r < rows_.reflectances; ++r) {
            const glm::dvec3 color = value * bin.colors[r];
            glm::dvec3* ofReflectance = &sums_[r * rows_.perReflectance()];
            ofReflectance[0] += color;
            if (!rows_.inBands) continue;
            ofReflectance[1 + bin.share.band] += (1.0 - bin.share.upper) * color;
            ofReflectance[2 + bin.share.band] += bin.share.upper * color;
        }
    }
    const std::vector<glm::dvec3>& sums() const { return sums_; }

private:
    ResponseRows rows_;
    std::vector<glm::dvec3> sums_;
};

constexpr int kLargestSlope = 255;  // nine bits with a sign
constexpr int kLargestShift = 31;

// 1, 1/2, 1/4, ...: std::ldexp is a call, and there are three numbers for every entry.
constexpr std::array<double, kLargestShift + 1> kHalves = [] {
    std::array<double, kLargestShift + 1> halves{1.0};
    for (std::size_t i = 1; i < halves.size(); ++i) halves[i] = 0.5 * halves[i - 1];
    return halves;
}();

// Three numbers of at most 255 2^31, as three of nine bits and what they are shifted by.
device::uint packedSlopes(glm::dvec3 slopes) {
    const double largest = std::max({std::abs(slopes.x), std::abs(slopes.y), std::abs(slopes.z)});
    std::size_t shift = 0;
    if (largest > kLargestSlope) {
        int exponent = 0;  // largest < 2^exponent
        std::frexp(largest, &exponent);
        shift = static_cast<std::size_t>(std::clamp(exponent - 8, 0, kLargestShift));
        if (shift < kLargestShift && largest * kHalves[shift] > kLargestSlope) ++shift;
    }
    device::uint packed = static_cast<device::uint>(shift) << 27;
    for (int i = 0; i < 3; ++i) {
        const double scaled = slopes[i] * kHalves[shift];
        const auto rounded = static_cast<int>(scaled + std::copysign(0.5, scaled));
        packed |= (static_cast<device::uint>(rounded) & 0x1ffU) << (9 * i);
    }
    return packed;
}

}  // namespace

void encode(const std::vector<glm::vec3>& density, SlitResponse& out) {
    constexpr double kLargestIntegral = 2147483647.0;  // differences fit a signed integer
    constexpr double kLeast = 1e-20;  // far below what a light sends, so that units stay normal floats
    const auto tables = static_cast<int>(density.size() / out.entries);
    const auto firstOf = [&](int table) { return static_cast<std::size_t>(table) * out.entries; };
    std::vector<std::pair<double, double>> extremes(static_cast<std::size_t>(tables));
    inParallel(tables, [&](int table) {
        const std::size_t first = firstOf(table);
        double steepest = kLeast;
        glm::dvec3 sum(0.0);
        for (std::size_t i = first; i + 1 < first + out.entries; ++i) {
            sum += 0.5 * (glm::dvec3(density[i]) + glm::dvec3(density[i + 1]));
            const glm::dvec3 slope = glm::abs(glm::dvec3(density[i + 1]) - glm::dvec3(density[i]));
            steepest = std::max({steepest, slope.x, slope.y, slope.z});
        }
        extremes[static_cast<std::size_t>(table)] = {std::max({kLeast, sum.x, sum.y, sum.z}), steepest};
    });
    double total = kLeast, steepest = kLeast;
    for (const auto& [tableTotal, tableSteepest] : extremes) {
        total = std::max(total, tableTotal);
        steepest = std::max(steepest, tableSteepest);
    }
    out.integralUnit = total / kLargestIntegral;
    const double slopeUnit = std::ldexp(steepest / kLargestSlope, -kLargestShift);
    out.slopeUnit = slopeUnit / out.integralUnit;
    out.values.resize(density.size());
    inParallel(tables, [&](int table) {
        const double perUnit = 1.0 / out.integralUnit, perSlope = 1.0 / slopeUnit;
        const std::size_t first = firstOf(table);
        glm::dvec3 sum(0.0);
        for (std::size_t i = first; i < first + out.entries; ++i) {
            const glm::dvec3 here(density[i]);
            const glm::dvec3 next(i + 1 < first + out.entries ? density[i + 1] : density[i]);
            const device::uint packed = packedSlopes((next - here) * perSlope);
            out.values[i] = {device::uvec3(sum * perUnit + 0.5), packed};
            sum += 0.5 * (here + next);
        }
    });
}

namespace {

// Everything that makeResponse() looks at.
TableMemo::Key keyOf(const LitSlits& lit, const optics::Spectrum& spectrum, const SpectralTables& tables,
                     bool zeroOrder, double perU) {
    TableMemo::Key key;
    key.add(lit.slits.count).add(lit.slits.width / units::um).add(lit.slits.period / units::um);
    key.add(lit.alphaIn).add(lit.betaIn).add(zeroOrder ? 1.0 : 0.0).add(perU);
    key.add(static_cast<double>(lit.orders.size()));
    for (const scene::OrderEfficiency& order : lit.orders) key.add(order.order).add(order.efficiency);
    key.add(tables.responseRows().inBands ? 1.0 : 0.0);
    return key.add(spectrum.density).addReflectances(tables);
}

// Of drafts: few slits have an eighth of the entries, which draws their fringes to 8 %; the first order of
// many comes in steps of 5.8 nm, from a spectrum in bins of 2 nm.
constexpr double kDraftOfFringes = 8.0, kDraftBin_nm = 2.0;
constexpr double kDraftOfOrders_um = 5.8e-3;

SlitResponse makeResponse(const LitSlits& lit, const optics::Spectrum& spectrum, const SpectralTables& tables,
                          bool zeroOrder, double wantedPerU, bool isDraft) {
    const double count = lit.slits.count;
    const double width_um = lit.slits.width / units::um;
    const double period_um = lit.slits.period / units::um;
    const double draftPerU = zeroOrder ? wantedPerU / kDraftOfFringes : period_um / kDraftOfOrders_um;
    const double perU = isDraft ? std::min(draftPerU, wantedPerU) : wantedPerU;
    const double extent_um = (count - 1.0) * period_um + width_um;
    const double conical = std::sqrt(1.0 - lit.betaIn * lit.betaIn);
    const double largestU = conical + std::abs(lit.alphaIn);

    // Wavelengths: four to the narrowest side lobe for the direct sum; bins of half a nanometre for the
    // orders.
    const double lobes = 13.0 * extent_um * largestU;
    const double step_nm = zeroOrder ? 400.0 / std::max(400.0, std::ceil(lobes))
                           : isDraft ? kDraftBin_nm
                                     : 0.5;
    const std::vector<WavelengthBin> bins = wavelengthBins(lit, spectrum, tables, step_nm);

    const auto below = static_cast<int>(std::ceil((conical + lit.alphaIn) * perU)) + 1;
    const auto above = static_cast<int>(std::ceil((conical - lit.alphaIn) * perU)) + 1;
    const auto entries = static_cast<device::uint>(below + above + 1);
    const ResponseRows rows = tables.responseRows();
    std::vector<glm::vec3> density(rows.all() * entries);

    const auto store = [&](std::size_t table, int signedEntry, glm::dvec3 color) {
        const int entry = signedEntry + below;
        if (entry < 0 || entry >= static_cast<int>(entries)) return;
        density[table * entries + static_cast<std::size_t>(entry)] = color;
    };

    // The undeviated beam is followed by the device as far as this; the rest of it is in the response.
    const double lastLobe = double{device::ZERO_ORDER_LOBES} * 1e-3 * optics::kLongestVisible_nm / extent_um;

    const OrderIntegrals integrals(count);

    // The spectrum is straight between the bins' wavelengths; what one of them stands for, in turns.
    std::vector<double> turnsPerU;
    for (const WavelengthBin& bin : bins) turnsPerU.push_back(period_um / bin.wavelength_um);
    const auto hatOf = [&](std::size_t i, double u) {
        const double shorter = turnsPerU[i > 0 ? i - 1 : i] * u,
                     longer = turnsPerU[i + 1 < bins.size() ? i + 1 : i] * u;
        return Hat{std::min(shorter, longer), turnsPerU[i] * u, std::max(shorter, longer)};
    };

    // Per unit of u, of an amplitude grating; it depends on |u| alone.
    const auto amplitudeGrating = [&](std::size_t i, double u) {
        const double wavelength_um = bins[i].wavelength_um;
        const double oneSlit = optics::sincSquared(width_um * u / wavelength_um) * width_um / wavelength_um;
        if (zeroOrder) return oneSlit * fejerKernel(count, period_um * u / wavelength_um);
        return oneSlit * integrals.diffracted(hatOf(i, u), u > lastLobe);
    };
    const auto givenOrders = [&](std::size_t i, double u) {
        const WavelengthBin& bin = bins[i];
        const Hat hat = hatOf(i, u);
        double sum = 0.0;
        for (std::size_t k = 0; k < lit.orders.size(); ++k) {
            const int order = lit.orders[k].order;
            if (zeroOrder) {
                sum += bin.orders[k] * count * optics::sincSquared(count * (hat.at - order));
            } else if (order != 0 || std::abs(u) > lastLobe) {
                sum += bin.orders[k] * integrals.ofOrder(order, hat);
            }
        }
        return sum * period_um / bin.wavelength_um;
    };

    // Orders spread the spectrum as their number says: at u there are those from the first on. So of the many
    // entries there only some are computed, in steps that are half of the first order's in wavelength.
    const auto strideAt = [&](int entry) {
        const double first = entry / perU * period_um / (1e-3 * optics::kLongestVisible_nm);
        return zeroOrder ? 1 : std::max(1, static_cast<int>(0.5 * first));
    };
    std::vector<int> computed;
    for (int entry = 0; entry < std::max(below, above); entry += strideAt(entry)) computed.push_back(entry);
    computed.insert(computed.end(), {below, above});  // where either side ends
    std::sort(computed.begin(), computed.end());
    computed.erase(std::unique(computed.begin(), computed.end()), computed.end());

    const auto storeAll = [&](int entry, const Accumulator& sums) {
        for (std::size_t table = 0; table < rows.all(); ++table) store(table, entry, sums.sums()[table]);
    };
    // Each entry is one thread's own.
    const auto writeEntry = [&](int number) {
        const int entry = computed[static_cast<std::size_t>(number)];
        const double u = entry / perU;
        if (lit.orders.empty()) {
            Accumulator sums(rows);
            for (std::size_t i = 0; i < bins.size(); ++i)
                sums.add(bins[i], bins[i].weight * amplitudeGrating(i, u));
            storeAll(entry, sums);
            storeAll(-entry, sums);
            return;
        }
        for (const int side : {1, -1}) {
            Accumulator sums(rows);
            for (std::size_t i = 0; i < bins.size(); ++i)
                sums.add(bins[i], bins[i].weight * givenOrders(i, side * u));
            storeAll(side * entry, sums);
        }
    };
    inParallel(static_cast<int>(computed.size()), writeEntry);

    // The others lie on straight lines.
    const auto writeBetween = [&](std::size_t table, int from, int to) {
        if (std::min(from, to) < -below || std::max(from, to) > above) return;
        const int side = from < to ? 1 : -1, count = std::abs(to - from);
        const glm::vec3* first = &density[table * entries + static_cast<std::size_t>(below)];
        const glm::vec3 start = first[from], end = first[to];
        for (int i = 1; i < count; ++i)
            store(table, from + side * i,
                  glm::mix(start, end, static_cast<float>(i) / static_cast<float>(count)));
    };
    inParallel(static_cast<int>(rows.all()), [&](int table) {
        for (std::size_t i = 1; i < computed.size(); ++i) {
            writeBetween(static_cast<std::size_t>(table), computed[i - 1], computed[i]);
            writeBetween(static_cast<std::size_t>(table), -computed[i - 1], -computed[i]);
        }
    });

    SlitResponse out{static_cast<device::uint>(below), perU, entries, 0.0, 0.0, {}};
    encode(density, out);
    return out;
}

}  // namespace

double LitSlits::propagatingShare(double wavelength_nm) const {
    if (!orders.empty()) return 1.0;
    return optics::propagatingShare(slits, wavelength_nm * units::nm, alphaIn, betaIn);
}

std::shared_ptr<const SlitResponse> slitResponse(const LitSlits& lit, const optics::Spectrum& spectrum,
                                                 const SpectralTables& tables, bool zeroOrder, double perU) {
    return rememberedOrDraft(tables.memo(), keyOf(lit, spectrum, tables, zeroOrder, perU), [&](bool isDraft) {
        return makeResponse(lit, spectrum, tables, zeroOrder, perU, isDraft);
    });
}

}  // namespace fringe::compile
