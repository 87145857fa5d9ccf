#include "qualify/evaluator_probe.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>

#include "compile/gratings.hpp"
#include "gpu/constant_block.hpp"
#include "shaders/bench_evaluators.comp.h"

namespace fringe::qualify {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kGroup = 64;

// Across the slits is -x.
scene::Grating gratingOf(const EvaluatorCase& which, const EvaluatorSetting& setting) {
    const optics::Slits slits = slitsOf(which);
    return {.position = {0, 0, 0},
            .normal = {0, 0, -1},
            .slitDirection = {0, 1, 0},
            .aperture = slits,
            .beam = {.profile = scene::BeamProfile::rectangle,
                     // No wider than the slits: their far field, unless pairs are wanted.
                     .width = (which.isWidelyLit ? 2.0 : 1.0) * which.count * slits.period,
                     .height = 1.0 * units::m,
                     .direction = {-which.incoming, 0, -std::sqrt(1.0 - which.incoming * which.incoming)},
                     .power = 1.0 * units::W,
                     .angularSize = {},
                     .focus = {}},
            .efficiency = 1.0,
            .efficiencies = {},
            .evaluator = setting.kind,
            .wavelengths = setting.wavelengths};
}

// The part of the one grating.
gpu::Texels::Part partOf(const compile::ResponseTables& responses) {
    if (responses.parts().empty()) return {};
    return {0, std::as_bytes(std::span(*responses.parts().front().table))};
}

// As `fringe render` has it.
gpu::TexelHome homeOf(const gpu::Device& device, const compile::ResponseTables& responses) {
    return gpu::fitTexelBuffer(device, partOf(responses).records.size()) ? gpu::TexelHome::buffer
                                                                         : gpu::TexelHome::image;
}

gpu::Texels texelsOf(const gpu::Device& device, const compile::ResponseTables& responses) {
    const gpu::Texels::Part part = partOf(responses);
    return {device, "response tables", std::span(&part, 1), homeOf(device, responses), device::TEXEL_ROW};
}

}  // namespace

std::uint64_t PreparedSlits::bytes() const {
    return scene.responses.size() * sizeof(device::ResponseEntry) + scene.tables.size() * sizeof(float);
}

PreparedSlits prepare(const EvaluatorCase& which, const EvaluatorSetting& setting, double tolerance) {
    const scene::Grating grating = gratingOf(which, setting);
    const auto& slits = std::get<optics::Slits>(grating.aperture);
    const compile::SpectralTables tables(compile::Measure::color, 1);
    PreparedSlits made;
    const Clock::time_point start = Clock::now();
    std::vector<compile::KnownSlits> known;
    made.scene.slitGratings.push_back(compile::compileSlits(grating, slits, which.spectrum, tables, tolerance,
                                                            made.scene.tables, made.scene.responses, known));
    made.buildSeconds = std::chrono::duration<double>(Clock::now() - start).count();
    made.scene.frame.reflectanceCount = 1;
    made.choice = compile::chooseEvaluator(grating, slits, which.spectrum, {}, tolerance);
    return made;
}

EvaluatorProbe::EvaluatorProbe(const gpu::Device& device, const PreparedSlits& prepared,
                               std::span<const EvaluatorWindow> windows)
    : device_(device),
      tables_(device, std::max<std::size_t>(prepared.scene.tables.size() * sizeof(float), 16),
              gpu::Access::hostWrites),
      responses_(texelsOf(device, prepared.scene.responses)),
      inputs_(device, windows.size_bytes(), gpu::Access::hostWrites),
      results_(device, windows.size() * sizeof(EvaluatorResult), gpu::Access::hostReads),
      kernel_(makeKernel(prepared)) {
    std::memcpy(tables_.mapped().data(), prepared.scene.tables.data(),
                prepared.scene.tables.size() * sizeof(float));
    std::memcpy(inputs_.mapped().data(), windows.data(), windows.size_bytes());
}

double EvaluatorProbe::run(std::size_t inputs) const {
    const gpu::Groups origin{0, 0, 0};
    const Clock::time_point start = Clock::now();
    kernel_.run({&origin, 1}, {static_cast<std::uint32_t>((inputs + kGroup - 1) / kGroup), 1, 1});
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::pair<glm::dvec3, bool> EvaluatorProbe::result(std::size_t i) const {
    const EvaluatorResult& r = reinterpret_cast<const EvaluatorResult*>(results_.mapped().data())[i];
    return {{r.x, r.y, r.z}, r.wasNonFinite == 0.0F};
}

gpu::Kernel EvaluatorProbe::makeKernel(const PreparedSlits& prepared) const {
    // As `fringe render` has it: the scene's values are constants of the shader.
    const device::SceneBlock block = compile::sceneBlock(prepared.scene);
    const std::vector<std::uint32_t> shader =
        gpu::withConstantBlock(bench_evaluators_comp, std::as_bytes(std::span(&block, 1)));
    const scene::Camera camera{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, scene::Orthographic{1.0}, {}};
    device::Specialisation specialisation = compile::specialise(prepared.scene, camera);
    if (homeOf(device_, prepared.scene.responses) == gpu::TexelHome::image)
        specialisation.TEXELS_IN_IMAGES = 1;
    std::array<std::uint32_t, device::kSpecialisationCount> constants{};
    std::memcpy(constants.data(), &specialisation, sizeof specialisation);

    // Numbers of bindings.glsl and of bench_evaluators.comp.
    constexpr std::size_t kResponses = 17, kResponseImage = 18, kInputs = 19, kResults = 20;
    const auto storage = vk::DescriptorType::eStorageBuffer;
    // Arrays that are never read are some buffer.
    std::vector<gpu::Binding> bindings(kResults + 1,
                                       gpu::Binding{storage, tables_.handle(), 0, tables_.size()});
    bindings[kResponses] = responses_.buffer();
    bindings[kResponseImage] = responses_.image();
    bindings[kInputs] = {storage, inputs_.handle(), 0, inputs_.size()};
    bindings[kResults] = {storage, results_.handle(), 0, results_.size()};
    return {device_, shader, bindings, constants};
}

}  // namespace fringe::qualify
