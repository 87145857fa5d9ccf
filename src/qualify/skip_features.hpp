// The features that a scene may lack, each as something that can be added to the room of bench_scenes.hpp
// where nobody sees it: behind the camera, facing away from the room, or of no power to speak of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "qualify/bench_scenes.hpp"

namespace fringe::qualify {

struct SkipFeature {
    std::string_view name;
    // The scene with and without it. What throws a shadow is compared with a scene that has shadows already,
    // what has a spectral table with slits that have none.
    std::string_view without;  // another feature, or the room
    // Members of the scene's arrays; empty: none.
    std::string material = {}, object = {}, light = {};
    bool lens = false;
};

inline constexpr std::string_view kRoom = "room";

const std::vector<SkipFeature>& skipFeatures();

void add(const SkipFeature& feature, SceneParts& scene);

}  // namespace fringe::qualify
