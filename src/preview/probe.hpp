// What passes between the instrument and the engine: where to measure, and what was found.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "profile/report.hpp"

namespace fringe::preview {

// A line on a surface; a point is a line as short as a photodiode, of one sample.
struct Probe {
    std::uint64_t number = 0;  // ascending
    glm::dvec3 from, to;
    glm::dvec3 eye;  // of a surface without an inside, the side towards it is measured
    std::uint32_t samples = 1;

    bool isPoint() const { return samples == 1; }
};

struct Measured {
    std::uint64_t probe = 0;                        // number of the one that it answers
    std::shared_ptr<const scene::Scene> scene;      // that it was measured in
    std::shared_ptr<const profile::Report> report;  // null: see error
    std::string error;
};

}  // namespace fringe::preview
