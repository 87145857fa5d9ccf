// Pictures for the tests: on the device, under the validation layer, and by the reference renderer.
#pragma once

#include <functional>
#include <string>

#include "compile/compiled_scene.hpp"
#include "image/image.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace fringe::testing {

// A scene file below the source folder.
scene::Scene sceneFile(const std::string& path);

struct Pipeline {
    render::Values values = render::Values::asConstants;                 // as `fringe render` has it
    std::function<void(device::Specialisation&)> change = [](auto&) {};  // of the constants
    compile::Measure measure = compile::Measure::color;
    std::function<void(compile::CompiledScene&)> changeScene = [](auto&) {};
    bool knowsLitTiles = false;  // as `fringe render` does
    std::uint32_t tile = 0;
};

// Any message of the validation layer fails the test that runs.
image::Image renderOnDevice(const scene::Scene& scene, const Pipeline& pipeline = {});

// A change of constants: texels in images, as on devices whose texel buffers are too small.
void texelsInImages(device::Specialisation& constants);

image::Image renderReference(const scene::Scene& scene);

// The largest difference of a channel.
double distance(const image::Pixel& a, const image::Pixel& b);

}  // namespace fringe::testing
