// Pictures for the tests: on the device, under the validation layer, and by the reference renderer.
#pragma once

#include <functional>
#include <string>

#include "compile/interface.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

namespace fringe::testing {

// A scene file below the source folder.
scene::Scene sceneFile(const std::string& path);

// Any message of the validation layer fails the test that runs. `change` may alter the pipeline's constants.
image::Image renderOnDevice(const scene::Scene& scene,
                            const std::function<void(device::Specialisation&)>& change = {});

image::Image renderReference(const scene::Scene& scene);

// The largest difference of a channel.
double distance(const image::Pixel& a, const image::Pixel& b);

}  // namespace fringe::testing
