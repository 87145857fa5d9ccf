// Which of the shader's features a scene needs.
#include <algorithm>

#include "compile/compiled_scene.hpp"

namespace fringe::compile {
namespace {

// 1 if any element's `kind` is the one asked for.
template <class Element>
device::uint any(const std::vector<Element>& elements, device::uint kind) {
    return std::any_of(elements.begin(), elements.end(), [kind](const Element& e) { return e.kind == kind; });
}

device::uint hasLens(const scene::Camera& camera) {
    const auto* perspective = std::get_if<scene::Perspective>(&camera.projection);
    return perspective != nullptr && perspective->lens.has_value();
}

bool hasCasters(const CompiledScene& compiled) {
    const bool flat =
        compiled.planeCasters + compiled.rectangleCasters + compiled.discCasters + compiled.triangleCasters >
        0;
    return flat || !compiled.spheres.empty() || !compiled.boxes.empty() || !compiled.cylinders.empty() ||
           !compiled.cones.empty();
}

}  // namespace

device::Specialisation specialise(const CompiledScene& compiled, const scene::Camera& camera) {
    const auto few = [](std::size_t size) {
        return static_cast<device::uint>(std::min<std::size_t>(size, device::FEW + 1));
    };
    const auto count = [&](const auto& elements) { return few(elements.size()); };
    const auto anySlits = [&](auto has) {
        return static_cast<device::uint>(
            std::any_of(compiled.slitGratings.begin(), compiled.slitGratings.end(), has));
    };
    // For a continuous spectrum.
    const auto anyEvaluator = [&](device::uint first, device::uint last) {
        return anySlits([=](const device::SlitGrating& g) {
            return g.entries > 0 && first <= g.evaluator && g.evaluator <= last;
        });
    };
    const auto anyOpening = [&](auto has) {
        return static_cast<device::uint>(
            std::any_of(compiled.openingGratings.begin(), compiled.openingGratings.end(), has));
    };
    const auto anyOpeningOf = [&](device::uint opening) {
        return anyOpening([opening](const device::OpeningGrating& g) { return g.opening == opening; });
    };
    // Of the polygons of a kind; FEW_EDGES + 1 if one has more than FEW_EDGES.
    const auto mostEdges = [&](device::uint opening) {
        device::uint most = 0;
        for (const device::OpeningGrating& grating : compiled.openingGratings)
            if (grating.opening == opening) most = std::max(most, grating.edgeCount);
        return std::min(most, device::FEW_EDGES + 1);
    };
    return {
        .PLANE_COUNT = count(compiled.planes),
        .RECTANGLE_COUNT = count(compiled.rectangles),
        .DISC_COUNT = count(compiled.discs),
        .SPHERE_COUNT = count(compiled.spheres),
        .BOX_COUNT = count(compiled.boxes),
        .CYLINDER_COUNT = count(compiled.cylinders),
        .CONE_COUNT = count(compiled.cones),
        .TRIANGLE_COUNT = count(compiled.triangles),
        .GRATING_COUNT = count(compiled.gratings),
        .LIGHT_COUNT = count(compiled.lights),
        .HAS_DIFFUSE = any(compiled.materials, device::DIFFUSE),
        .HAS_CONDUCTORS = any(compiled.materials, device::CONDUCTOR),
        .HAS_DIELECTRICS = any(compiled.materials, device::DIELECTRIC),
        .HAS_EMITTERS = any(compiled.materials, device::EMISSIVE),
        .HAS_THESIS_DISCS = any(compiled.materials, device::THESIS_DISC),
        .HAS_POINT_LIGHTS = any(compiled.lights, device::POINT_LIGHT),
        .HAS_SPOT_LIGHTS = any(compiled.lights, device::SPOT_LIGHT),
        .HAS_DIRECTIONAL_LIGHTS = any(compiled.lights, device::DIRECTIONAL_LIGHT),
        .HAS_RECTANGLE_LIGHTS = any(compiled.lights, device::RECTANGLE_LIGHT),
        .HAS_DISC_LIGHTS = any(compiled.lights, device::DISC_LIGHT),
        .HAS_SPHERE_LIGHTS = any(compiled.lights, device::SPHERE_LIGHT),
        .HAS_ENVIRONMENT = any(compiled.lights, device::ENVIRONMENT_LIGHT),
        .HAS_PRINTED_FAULTS = compiled.printedFaults,
        .IS_ORTHOGRAPHIC = std::holds_alternative<scene::Orthographic>(camera.projection),
        .HAS_LENS = hasLens(camera),
        .HAS_SEVERAL_SAMPLES = compiled.samples > 1,
        .MAX_DEPTH = compiled.maxDepth,
        .PLANE_CASTERS = few(compiled.planeCasters),
        .RECTANGLE_CASTERS = few(compiled.rectangleCasters),
        .DISC_CASTERS = few(compiled.discCasters),
        .TRIANGLE_CASTERS = few(compiled.triangleCasters),
        .MATERIAL_COUNT = count(compiled.materials),
        .SLIT_GRATING_COUNT = count(compiled.slitGratings),
        .HAS_SLIT_LINES = anySlits([](const device::SlitGrating& g) { return g.lineCount > 0; }),
        .HAS_SLIT_CONTINUUM = anyEvaluator(device::TABLE_EVALUATOR, device::NAIVE_EVALUATOR),
        .HAS_WIDE_GRATINGS =
            anySlits([](const device::SlitGrating& g) { return g.isWide + g.linesAreImages != 0; }),
        .HAS_GAUSSIAN_BEAMS =
            anySlits([](const device::SlitGrating& g) { return g.profile == device::GAUSSIAN_BEAM; }),
        .HAS_ORDER_SHARES = anySlits([](const device::SlitGrating& g) { return g.orderCount > 0; }),
        .OPENING_GRATING_COUNT = count(compiled.openingGratings),
        .HAS_RECTANGULAR_OPENINGS = anyOpeningOf(device::RECTANGULAR_OPENING),
        .HAS_CIRCULAR_OPENINGS = anyOpeningOf(device::CIRCULAR_OPENING),
        .HAS_RING_OPENINGS = anyOpeningOf(device::RING_OPENING),
        .HAS_POLYGONAL_OPENINGS = anyOpeningOf(device::POLYGONAL_OPENING),
        .HAS_MASK_OPENINGS = anyOpeningOf(device::MASK_OPENING),
        .HAS_LATTICES = anyOpening([](const device::OpeningGrating& g) { return g.isLattice != 0; }),
        .HAS_WIDE_SOURCES = anyOpening([](const device::OpeningGrating& g) { return g.sourceBlur > 0.0F; }),
        .HAS_SYMMETRIC_OPENINGS = anyOpeningOf(device::SYMMETRIC_OPENING),
        .POLYGON_EDGES = mostEdges(device::POLYGONAL_OPENING),
        .SYMMETRIC_EDGES = mostEdges(device::SYMMETRIC_OPENING),
        .SAMPLES_AT_HAND = static_cast<device::uint>(compiled.openingSamples.size()),
        .IS_SPECTRUM = compiled.isSpectrum,
        .OPTICAL_DISC_COUNT = count(compiled.opticalDiscs),
        .HAS_SCATTERING = std::any_of(compiled.opticalDiscs.begin(), compiled.opticalDiscs.end(),
                                      [](const device::OpticalDisc& d) { return d.scattering > 0.0F; }),
        .HAS_DISC_CONTINUUM = compiled.discContinuum,
        .HAS_DISC_LINES = compiled.discLines,
        .HAS_HUBS = compiled.clearHubs,
        .HAS_GROOVES = std::any_of(compiled.opticalDiscs.begin(), compiled.opticalDiscs.end(),
                                   [](const device::OpticalDisc& d) { return d.grooveSlope > 0.0F; }),
        .CASTING_DISC_COUNT = compiled.castingDiscs,
        .HAS_RIPPLES = compiled.ripples,
        .TREE_DEPTH = compiled.tree.depth,
        .HAS_TABLE_EVALUATOR = anyEvaluator(device::TABLE_EVALUATOR, device::TABLE_EVALUATOR),
        .HAS_ORDERS_EVALUATOR = anyEvaluator(device::ORDERS_EVALUATOR, device::ORDERS_EVALUATOR),
        .HAS_DIRECT_EVALUATOR = anyEvaluator(device::DIRECT_EVALUATOR, device::NAIVE_EVALUATOR),
        .HAS_SMALL_ANGLE_EVALUATOR = anySlits(
            [](const device::SlitGrating& g) { return g.evaluator == device::SMALL_ANGLE_EVALUATOR; }),
        .HAS_NAIVE_EVALUATOR =
            anySlits([](const device::SlitGrating& g) { return g.evaluator == device::NAIVE_EVALUATOR; }),
        .HAS_PAIRS_EVALUATOR =
            anySlits([](const device::SlitGrating& g) { return g.evaluator == device::PAIRS_EVALUATOR; }),
        .HAS_BAND_RESPONSES = compiled.bandResponses && !compiled.slitGratings.empty(),
        .HAS_NEAR_OPENINGS = anyOpening([](const device::OpeningGrating& g) { return g.isNear != 0; }),
        .HAS_SHADOWS = compiled.castsShadows && hasCasters(compiled),
        .EVEN_SAMPLES = compiled.evenOpeningSamples,
        .HAS_UNEVEN_LATTICES = anyOpening([](const device::OpeningGrating& g) { return g.isUneven != 0; }),
        .HAS_GAUSSIAN_OPENINGS = anyOpeningOf(device::GAUSSIAN_OPENING),
        .HAS_NEAR_LAYERS = anyOpening([](const device::OpeningGrating& g) { return g.hasLayers != 0; }),
    };
}

device::Specialisation withoutGratings(device::Specialisation constants) {
    constants.GRATING_COUNT = constants.SLIT_GRATING_COUNT = constants.OPENING_GRATING_COUNT = 0;
    constants.HAS_SLIT_LINES = constants.HAS_SLIT_CONTINUUM = constants.HAS_WIDE_GRATINGS = 0;
    constants.HAS_GAUSSIAN_BEAMS = constants.HAS_ORDER_SHARES = constants.HAS_RIPPLES = 0;
    constants.HAS_RECTANGULAR_OPENINGS = constants.HAS_CIRCULAR_OPENINGS = constants.HAS_RING_OPENINGS = 0;
    constants.HAS_POLYGONAL_OPENINGS = constants.HAS_SYMMETRIC_OPENINGS = constants.HAS_MASK_OPENINGS = 0;
    constants.HAS_LATTICES = constants.HAS_UNEVEN_LATTICES = constants.HAS_GAUSSIAN_OPENINGS =
        constants.HAS_WIDE_SOURCES = 0;
    constants.SAMPLES_AT_HAND = constants.EVEN_SAMPLES = 0;
    constants.POLYGON_EDGES = constants.SYMMETRIC_EDGES = 0;
    constants.HAS_TABLE_EVALUATOR = constants.HAS_ORDERS_EVALUATOR = constants.HAS_DIRECT_EVALUATOR = 0;
    constants.HAS_SMALL_ANGLE_EVALUATOR = constants.HAS_NAIVE_EVALUATOR = constants.HAS_PAIRS_EVALUATOR = 0;
    constants.HAS_BAND_RESPONSES = 0;
    return constants;
}

}  // namespace fringe::compile
