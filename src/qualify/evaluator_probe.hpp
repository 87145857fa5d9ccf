// Slits as `fringe render` compiles and evaluates them, on the device: one of a case's evaluators at many
// inputs.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "compile/compiled_scene.hpp"
#include "compile/evaluators.hpp"
#include "gpu/kernel.hpp"
#include "gpu/texels.hpp"
#include "qualify/evaluator_cases.hpp"

namespace fringe::qualify {

// A way to the colour of slits, as a scene asks for it.
struct EvaluatorSetting {
    std::string evaluator;
    std::string name;
    scene::Evaluator kind;
    std::optional<std::uint32_t> wavelengths;
};

struct PreparedSlits {
    compile::CompiledScene scene;
    compile::EvaluatorChoice choice;
    double buildSeconds = 0.0;

    const device::SlitGrating& grating() const { return scene.slitGratings.front(); }
    std::uint64_t bytes() const;  // of their tables
};

PreparedSlits prepare(const EvaluatorCase& which, const EvaluatorSetting& setting, double tolerance);

// An input of bench_evaluators.comp, and its result.
struct EvaluatorWindow {
    float u;
    float width;
};
struct EvaluatorResult {
    float x, y, z;
    float wasNonFinite;
};

class EvaluatorProbe {
public:
    // Keeps a reference to the device. Throws gpu::DeviceError.
    EvaluatorProbe(const gpu::Device& device, const PreparedSlits& prepared,
                   std::span<const EvaluatorWindow> windows);

    // The first `inputs` windows. Returns how long the host waited, in milliseconds.
    double run(std::size_t inputs) const;

    // XYZ for window `i`, per unit of u and of the power, and whether it is a number.
    std::pair<glm::dvec3, bool> result(std::size_t i) const;

private:
    gpu::Kernel makeKernel(const PreparedSlits& prepared) const;

    const gpu::Device& device_;
    gpu::Buffer tables_;
    gpu::Texels responses_;
    gpu::Buffer inputs_;
    gpu::Buffer results_;
    gpu::Kernel kernel_;  // needs all of them
};

}  // namespace fringe::qualify
