// Scene -> CompiledScene: the camera, the tables' order, and the parts in theirs.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "compile/compiled_scene.hpp"
#include "compile/discs.hpp"
#include "compile/grating_grid.hpp"
#include "compile/gratings.hpp"
#include "compile/lights.hpp"
#include "compile/materials.hpp"
#include "compile/number.hpp"
#include "compile/ripples.hpp"
#include "compile/shapes.hpp"
#include "compile/table_memo.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;

device::Camera compileCamera(const scene::Camera& camera, double aspect) {
    const dvec3 forward = glm::normalize(camera.target - camera.position);
    const dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const dvec3 up = glm::cross(right, forward);
    device::Camera packed{};
    packed.position = toFloat(camera.position);
    packed.forward = toFloat(forward);
    double halfHeight = 0.0;
    if (const auto* perspective = std::get_if<scene::Perspective>(&camera.projection)) {
        halfHeight = std::tan(0.5 * (perspective->fov / units::rad));
        if (perspective->lens) {
            const double lensRadius = 0.5 * (perspective->lens->diameter / units::m);
            packed.lensRight = toFloat(lensRadius * right);
            packed.lensUp = toFloat(lensRadius * up);
            packed.focusDistance = toFloat(perspective->lens->focusDistance / units::m);
        }
    } else {
        halfHeight = 0.5 * std::get<scene::Orthographic>(camera.projection).height;
    }
    packed.right = toFloat(halfHeight * aspect * right);
    packed.up = toFloat(halfHeight * up);
    return packed;
}

// How much of the scene one sample stands for.
void setPixelWidth(const scene::Camera& camera, const scene::Image& image, device::Frame& frame) {
    const double share = 2.0 / image.height / std::sqrt(1.0 * image.samples);
    frame.pixelAngle = frame.pixelWidth = 0.0F;
    if (const auto* perspective = std::get_if<scene::Perspective>(&camera.projection)) {
        frame.pixelAngle = toFloat(share * std::tan(0.5 * (perspective->fov / units::rad)));
    } else {
        frame.pixelWidth = toFloat(0.5 * share * std::get<scene::Orthographic>(camera.projection).height);
    }
}

bool isMetal(const scene::Material& material) {
    return std::holds_alternative<scene::Conductor>(material.model) ||
           std::holds_alternative<scene::OpticalDisc>(material.model);
}

// The colours come first in the tables; gratings, whose places are known, have written theirs already.
void addColors(const SpectralTables& tables, CompiledScene& out) {
    const std::vector<float> colors = tables.colors();
    const std::vector<float> metals = tables.metalIndices();
    const device::uint shift = count(colors.size() + metals.size());
    out.tables.insert(out.tables.begin(), metals.begin(), metals.end());
    out.tables.insert(out.tables.begin(), colors.begin(), colors.end());
    out.frame.reflectanceCount = count(tables.reflectances().size());
    out.frame.metals = count(colors.size());
    for (device::SlitGrating& grating : out.slitGratings) {
        grating.lines += shift;
        grating.zeroOrder += shift;
        grating.shares += shift;
    }
    for (device::OpeningGrating& grating : out.openingGratings) {
        grating.table += shift;
        grating.cells += shift;
        grating.samples += shift;
        grating.layers += shift;
    }
    for (device::OpticalDisc& disc : out.opticalDiscs) {
        disc.orders += shift;
        disc.scatteringShares += shift;
    }
}

// Lines come after the even steps of a continuous spectrum.
void findEvenSamples(double step, CompiledScene& out) {
    const dvec3 nodes(device::MEAN_WAVENUMBERS);
    std::array<dvec3, 3> means{};
    for (const device::OpeningSample& sample : out.openingSamples) {
        const double wavenumber = sample.wavenumber;
        const double even = out.openingSamples.front().wavenumber + out.evenOpeningSamples * step;
        if (!(std::abs(wavenumber - even) < 1e-5 * wavenumber)) break;
        ++out.evenOpeningSamples;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            const double parabola = (wavenumber - nodes[j]) * (wavenumber - nodes[k]) /
                                    ((nodes[i] - nodes[j]) * (nodes[i] - nodes[k]));
            means[static_cast<std::size_t>(i)] += parabola / std::pow(wavenumber, 3) * dvec3(sample.color);
        }
    }
    std::copy(means.begin(), means.end(), out.openingMeans.begin());
}

// A single opening's spectrum where every surface sees the same one: then the device need not look it up.
void takeSamplesAtHand(CompiledScene& out) {
    if (out.openingGratings.size() != 1 || out.frame.reflectanceCount != 1) return;
    const device::OpeningGrating& grating = out.openingGratings.front();
    if (grating.sampleCount > device::FEW_SAMPLES || grating.sourceBlur > 0.0F) return;
    if (grating.isNear != 0 || grating.hasLayers != 0) return;
    for (device::uint i = 0; i < grating.sampleCount; ++i) {
        const float* color = &out.tables[grating.samples + 3 * grating.sampleCount + 3 * i];
        out.openingSamples.push_back({out.tables[grating.samples + 3 * i], {color[0], color[1], color[2]}});
    }
    if (grating.opening == device::SYMMETRIC_OPENING && grating.isLattice == 0 && !out.inBands)
        findEvenSamples(grating.wavenumberStep, out);
}

void addCastingDiscs(const scene::Scene& scene, CompiledScene& out) {
    out.frame.castingDiscs = count(out.tables.size());
    for (const scene::Object& object : scene.objects) {
        const auto* disc = std::get_if<scene::OpticalDisc>(&scene.materials[object.material].model);
        const auto* shape = std::get_if<scene::Disc>(&object.shape);
        if (disc == nullptr || shape == nullptr || !disc->castsLight) continue;
        ++out.castingDiscs;
        for (int i = 0; i < 3; ++i) out.tables.push_back(toFloat(shape->center[i]));
        for (int i = 0; i < 3; ++i) out.tables.push_back(toFloat(shape->normal[i]));
        out.tables.push_back(toFloat(shape->radius));
        out.tables.push_back(static_cast<float>(out.materials[object.material].row));
    }
}

void addDiscSpectra(const SpectralTables& tables, CompiledScene& out) {
    out.frame.discSpectra = count(out.tables.size());
    const std::vector<float> values = discSpectra(tables);
    out.tables.insert(out.tables.end(), values.begin(), values.end());
    for (const optics::Spectrum& spectrum : tables.spectra()) {
        out.discContinuum = out.discContinuum || !spectrum.density.empty();
        out.discLines = out.discLines || !spectrum.lines.empty();
    }
}

}  // namespace

void setView(const scene::Camera& camera, const scene::Image& image, device::Frame& frame) {
    frame.camera = compileCamera(camera, double{1.0} * image.width / image.height);
    frame.width = image.width;
    frame.height = image.height;
    frame.filmWidth = (frame.width + device::GROUP_EDGE - 1) / device::GROUP_EDGE * device::GROUP_EDGE;
    frame.seed = image.seed;
    setPixelWidth(camera, image, frame);
}

CompiledScene compileScene(const scene::Scene& scene, Measure measure, TableMemo* memo, Viewpoint viewpoint) {
    if (memo != nullptr) memo->beginScene();
    CompiledScene out;
    device::Frame& frame = out.frame;
    setView(scene.camera, scene.image, frame);
    out.samples = scene.image.samples;
    out.castsShadows = scene.castsShadows;
    out.printedFaults = scene::hasPrintedFaults(scene);
    if (std::any_of(scene.materials.begin(), scene.materials.end(), isSpecular))
        out.maxDepth = scene.image.maxDepth;

    out.isSpectrum = measure == Measure::spectrum;
    if (out.isSpectrum) frame.height = device::SPECTRAL_BANDS;
    out.inBands = out.isSpectrum || std::any_of(scene.materials.begin(), scene.materials.end(), isMetal);

    // Reflectances first: what a light needs depends on what it falls on.
    SpectralTables tables(measure, out.inBands ? device::SPECTRAL_BANDS : 1, memo);
    const auto showRipples = [&](std::span<const device::SlitGrating> beams) {
        return viewpoint == Viewpoint::moving ? !beams.empty() : ripplesShow(scene, frame, beams);
    };
    out.bandResponses = out.inBands || showRipples(continuousBeams(scene));
    if (out.bandResponses) tables.divideResponses();
    addMaterials(scene, tables, out);
    addGlowingObjects(scene, tables, out);
    const device::uint firstLightMaterial = count(out.materials.size());
    addLights(scene, tables, out);
    addShapes(scene, firstLightMaterial, out);
    addColors(tables, out);
    takeSamplesAtHand(out);
    if (!out.opticalDiscs.empty()) addDiscSpectra(tables, out);
    addCastingDiscs(scene, out);
    addGratingGrid(scene, out);
    out.ripples = showRipples(out.slitGratings);
    return out;
}

}  // namespace fringe::compile
