// The scenes that frames are benchmarked on, as text in the scene format: part of the program, so that an
// installed one needs no scene files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fringe::qualify {

// Members of arrays and objects of a scene file, each a piece of JSON.
struct SceneParts {
    std::uint32_t size = 600;  // of the square picture
    std::uint32_t samples = 1;
    std::string camera;
    std::vector<std::string> materials;  // "name": {...}
    std::vector<std::string> objects;
    std::vector<std::string> lights;

    std::string text() const;
};

// The open box of the thesis's figure 24 under its lamp, without gratings: white, red and green walls, none
// of which can throw a shadow.
SceneParts roomScene();

enum class GratingModel { thesis, physical };

// In that room five gratings of one to five slits, 1 um wide and 2 um apart; the physical ones in daylight.
SceneParts fiveGratingsScene(GratingModel model);

// In that room under a lamp as large as a tray, seen through a lens: a sphere with its soft shadow and one
// grating. What an image needs many samples for.
SceneParts softScene();

// In that room `count` gratings of two slits in the light of a helium-neon laser, evenly over the back wall.
// Where they are `hidden` they stand behind the camera and shine away from all that is seen.
SceneParts manyGratingsScene(std::uint32_t count, bool hidden);

// Over a floor `count` spheres, at places that are the same everywhere; their volumes add up to the same for
// every count, so that they fill as much of the picture.
SceneParts spheresScene(std::uint32_t count);

// Nothing: the smallest shader that writes a picture.
SceneParts emptyScene();

}  // namespace fringe::qualify
