#include "render/rendering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "gpu/device.hpp"
#include "oracle/reference.hpp"
#include "scene/parse.hpp"
#include "wanted_device.hpp"

namespace fringe::testing {

scene::Scene sceneFile(const std::string& path) {
    const std::string absolute = std::string(FRINGE_SOURCE_DIR) + "/" + path;
    std::ifstream file(absolute);
    std::ostringstream text;
    text << file.rdbuf();
    return scene::parseScene(text.str(), absolute);
}

image::Image renderOnDevice(const scene::Scene& scene, const Pipeline& pipeline) {
    static const gpu::Device device({.selector = wantedDevice(), .validation = true});
    const std::size_t messagesBefore = device.validationMessages().size();
    compile::CompiledScene compiled = compile::compileScene(scene, pipeline.measure);
    pipeline.changeScene(compiled);
    device::Specialisation constants = compile::specialise(compiled, scene.camera);
    pipeline.change(constants);
    render::Renderer renderer(
        device, compiled, constants, pipeline.values,
        pipeline.knowsLitTiles ? compile::litTiles(scene, compiled) : compile::LitTiles());
    image::Image picture{scene.image.width, scene.image.height, {}};
    const std::atomic<bool> never{false};
    renderer.render({.cancelled = never,
                     .onProgress = {},
                     .onBand =
                         [&](const render::Band& band) {
                             picture.pixels.insert(picture.pixels.end(), band.pixels.begin(),
                                                   band.pixels.end());
                         },
                     .tile = pipeline.tile});
    const auto messages = device.validationMessages();
    for (std::size_t i = messagesBefore; i < messages.size(); ++i)
        ADD_FAILURE() << "validation: " << messages[i];
    return picture;
}

void texelsInImages(device::Specialisation& constants) {
    constants.TEXELS_IN_IMAGES = 1;
}

image::Image renderReference(const scene::Scene& scene) {
    image::Image picture{scene.image.width, scene.image.height, {}};
    picture.pixels.resize(std::size_t{picture.width} * picture.height);
    const std::atomic<bool> never{false};
    EXPECT_TRUE(oracle::Reference(scene).render(0, picture.height, picture.pixels, 2, never));
    return picture;
}

double distance(const image::Pixel& a, const image::Pixel& b) {
    return std::max({std::abs(double{a.x} - b.x), std::abs(double{a.y} - b.y), std::abs(double{a.z} - b.z)});
}

}  // namespace fringe::testing
