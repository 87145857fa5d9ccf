// The scene as the device gets it: floats, flat arrays, and the constants of the pipeline that it needs.
#pragma once

#include <vector>

#include "compile/interface.hpp"
#include "compile/response_tables.hpp"
#include "compile/spectral.hpp"
#include "compile/tree.hpp"
#include "scene/scene.hpp"

namespace fringe::compile {

struct CompiledScene {
    device::Frame frame{};
    std::uint32_t samples = 1;   // per pixel
    std::uint32_t maxDepth = 0;  // of mirrors and glass; 0 where there are none
    bool printedFaults = false;  // some 0/0 is to be left in, flagged
    // The first so many of each flat kind can throw a shadow; of the others all.
    std::uint32_t planeCasters = 0, rectangleCasters = 0, discCasters = 0, triangleCasters = 0;
    bool castsShadows = true;  // false: none is thrown
    std::vector<device::Plane> planes;
    std::vector<device::Rectangle> rectangles;
    std::vector<device::Disc> discs;
    std::vector<device::Sphere> spheres;
    std::vector<device::Box> boxes;
    std::vector<device::Cylinder> cylinders;
    std::vector<device::Cone> cones;
    std::vector<device::Triangle> triangles;
    Tree tree;  // of the shapes whose kind has more than FEW
    std::vector<device::Material> materials;
    std::vector<device::Light> lights;
    std::vector<device::ThesisGrating> gratings;
    std::vector<device::SlitGrating> slitGratings;
    std::vector<device::OpeningGrating> openingGratings;
    std::vector<device::OpeningSample> openingSamples;  // if it fits in the uniform block
    std::uint32_t evenOpeningSamples = 0;  // of these, the first so many that shaders/even_waves.glsl adds up
    std::array<device::vec3, 3> openingMeans{};  // SceneBlock.openingMeans
    bool ripples = false;                        // beams of slits may show the Fresnel ripple of their edges
    bool inBands = false;     // paths carry spectral bands: there are metals, or the film holds a spectrum
    bool isSpectrum = false;  // a band in each row: Measure::spectrum
    std::vector<device::OpticalDisc> opticalDiscs;
    bool clearHubs = false;                         // of discs: a path may go on behind one
    std::uint32_t castingDiscs = 0;                 // that light their surroundings
    bool discContinuum = false, discLines = false;  // what of spectra discs diffract
    ResponseTables responses;                       // of slits to continuous spectra
    bool bandResponses = false;  // they are for each band too, not for all bands' sum alone
    std::vector<float> tables;   // colours, refractive indices, and what gratings need beside their record
};

// Whether the scene is seen by its own camera alone, or setView() may come as close as it likes.
enum class Viewpoint { fixed, moving };

// The only place where units become floats. The same for the same scene; a memo only spares time
// (table_memo.hpp), unless drafts are wanted of it.
CompiledScene compileScene(const scene::Scene& scene, Measure measure = Measure::color,
                           TableMemo* memo = nullptr, Viewpoint viewpoint = Viewpoint::fixed);

// The part of `frame` that depends on where the scene is seen from, and on the picture's size and samples.
// The rest of a CompiledScene does not if it is for Viewpoint::moving.
void setView(const scene::Camera& camera, const scene::Image& image, device::Frame& frame);

// The uniform block: the frame, and the arrays that have no more than FEW elements.
device::SceneBlock sceneBlock(const CompiledScene& scene);

// Which features the scene has. Pure; depends on the scene's structure, and on values only where these make
// certain that something never shows (shadows, ripples).
device::Specialisation specialise(const CompiledScene& compiled, const scene::Camera& camera);

// The same features but for gratings.
device::Specialisation withoutGratings(device::Specialisation constants);

}  // namespace fringe::compile
