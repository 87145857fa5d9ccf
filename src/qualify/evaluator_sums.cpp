#include "qualify/evaluator_sums.hpp"

#include <bit>
#include <cmath>

#include "oracle/exact_pattern.hpp"

namespace fringe::qualify {

using glm::dvec3;

Waves wavesOf(const PreparedSlits& prepared) {
    const device::SlitGrating& g = prepared.grating();
    const auto real = [](device::uint bits) { return std::bit_cast<float>(bits); };
    const std::vector<device::ResponseEntry> entries = compile::entriesOf(prepared.scene.responses);
    Waves list{g.count, {}};
    for (device::uint i = 0; i < g.entries; ++i) {
        const device::ResponseEntry& wave = entries[g.response + i];
        const device::ResponseEntry& color = entries[g.response + g.entries + i];
        list.waves.push_back({real(wave.integral.x), real(wave.integral.y), real(wave.integral.z),
                              dvec3(real(color.integral.x), real(color.integral.y), real(color.integral.z))});
    }
    return list;
}

dvec3 sumAt(const Waves& list, double u, double undeviatedUpTo) {
    dvec3 sum(0.0);
    for (const Waves::Wave& wave : list.waves) {
        const double past = oracle::turnsPast(u, wave.periodHigh, wave.periodLow);
        double value = oracle::slitPattern(u * wave.width) * oracle::arrayPattern(past, list.count);
        if (std::abs(u) < undeviatedUpTo) {
            value -= oracle::slitPattern(u * wave.width) *
                     oracle::slitPattern(list.count * u * (double{wave.periodHigh} + wave.periodLow));
        }
        sum += value * wave.color;
    }
    return sum;
}

CpuWaves forProcessor(const Waves& list) {
    CpuWaves waves{static_cast<float>(list.count), {}, {}, {}, {}, {}};
    for (const Waves::Wave& wave : list.waves) {
        waves.period.push_back(wave.periodHigh);
        waves.width.push_back(wave.width);
        waves.x.push_back(static_cast<float>(wave.color.x));
        waves.y.push_back(static_cast<float>(wave.color.y));
        waves.z.push_back(static_cast<float>(wave.color.z));
    }
    return waves;
}

}  // namespace fringe::qualify
