#include "scene/scene.hpp"

#include <algorithm>

namespace fringe::scene {

bool hasPrintedFaults(const Scene& scene) {
    const auto asPrinted = [](const auto& element) {
        return std::visit(
            [](const auto& model) {
                if constexpr (requires { model.faults; }) return model.faults == Faults::asPrinted;
                else if constexpr (requires { model.evaluator; }) return model.evaluator == Evaluator::naive;
                else return false;
            },
            element.model);
    };
    return std::any_of(scene.materials.begin(), scene.materials.end(), asPrinted) ||
           std::any_of(scene.lights.begin(), scene.lights.end(), asPrinted);
}

}  // namespace fringe::scene
