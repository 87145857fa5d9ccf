// The uniform block of a compiled scene.
#include <algorithm>

#include "compile/compiled_scene.hpp"

namespace fringe::compile {
namespace {

template <class Element>
void copyFew(const std::vector<Element>& from, Element (&to)[device::FEW]) {
    if (from.size() <= device::FEW) std::copy(from.begin(), from.end(), to);
}

}  // namespace

device::SceneBlock sceneBlock(const CompiledScene& scene) {
    device::SceneBlock block{};
    block.frame = scene.frame;
    copyFew(scene.planes, block.planes);
    copyFew(scene.rectangles, block.rectangles);
    copyFew(scene.discs, block.discs);
    copyFew(scene.spheres, block.spheres);
    copyFew(scene.boxes, block.boxes);
    copyFew(scene.cylinders, block.cylinders);
    copyFew(scene.cones, block.cones);
    copyFew(scene.triangles, block.triangles);
    copyFew(scene.materials, block.materials);
    copyFew(scene.lights, block.lights);
    copyFew(scene.gratings, block.gratings);
    copyFew(scene.slitGratings, block.slitGratings);
    copyFew(scene.openingGratings, block.openingGratings);
    std::copy(scene.openingSamples.begin(), scene.openingSamples.end(), block.openingSamples);
    std::copy(scene.openingMeans.begin(), scene.openingMeans.end(), block.openingMeans);
    copyFew(scene.opticalDiscs, block.opticalDiscs);
    return block;
}

}  // namespace fringe::compile
