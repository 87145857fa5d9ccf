// What a scene asks for that the renderer shows wrongly: not an error, but not to be kept from its author.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace fringe::compile {

struct Warning {
    std::string light;    // its name, or lights[index]
    std::string message;  // what is wrong, the number that says so, and a remedy
};

// In the order of the lights. Pure, and quick: nothing is compiled for it.
std::vector<Warning> warningsOf(const scene::Scene& scene);

}  // namespace fringe::compile
