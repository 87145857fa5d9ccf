// A sum over wavelengths on the processor, in single precision: what a plain program for it would do, and
// what the device's evaluators are timed against. Compiled with -O3 -march=native -ffast-math.
#pragma once

#include <span>
#include <vector>

namespace fringe::qualify {

struct CpuWaves {
    float count;                // of slits
    std::vector<float> period;  // and width of the slits, in wavelengths
    std::vector<float> width;
    std::vector<float> x, y, z;  // of the pattern's peak
};

// X, Y, Z for each u, three floats each.
void cpuSum(const CpuWaves& waves, std::span<const float> u, std::span<float> xyz);

}  // namespace fringe::qualify
