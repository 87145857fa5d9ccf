// Parts of a scene that the user has switched off, and the one wavelength that is looked at: for display
// alone, the scene file and the changes to it stay as they are.
#pragma once

#include <cstddef>
#include <optional>
#include <set>

#include "scene/scene.hpp"

namespace fringe::preview {

struct Switches {
    std::set<std::size_t> darkLights = {};     // by their number in the scene file
    bool mattOnly = false;                     // mirrors, glass and discs are grey walls
    bool noShadows = false;                    // all surfaces let light through, but on the way to the eye
    std::optional<double> wavelength_nm = {};  // nothing: all of them

    bool operator==(const Switches&) const = default;
};

// Of the light that a view of one wavelength shows: half of it on either side.
inline constexpr double kBand_nm = 10.0;

// Gratings and discs of the thesis know colours and no wavelengths: with one, the gratings are dark.
scene::Scene switched(scene::Scene scene, const Switches& switches);

}  // namespace fringe::preview
