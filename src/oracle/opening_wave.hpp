// Light behind a small opening, far away from it (docs/theory.md): the same interface as SlitWave has.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "oracle/opening.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

class OpeningWave {
public:
    OpeningWave(const scene::Grating& grating, const OpeningShape& shape);

    struct View {
        std::optional<Opening> opening;  // nothing where no light gets
        glm::dvec2 turn;                 // change of the direction cosines
        double geometry;                 // 1 / m^2: obliquity, cosine and inverse square
    };
    View view(const glm::dvec3& offset, const glm::dvec3& normal, const glm::dvec2& incident) const;

    double irradiance(const View& view, double wavelength) const;
    double propagatingShare(double wavelength, const glm::dvec2& incident) const;
    double spread(const View& view) const;

    // Steps of the wavelength at which the share is known well enough.
    double shareStep_nm() const;
    glm::dvec3 source(const glm::dvec3& offset, const glm::dvec2& incident) const;
    glm::dvec2 extent() const;

private:
    OpeningShape shape_;
    double area_;
    double extent_;
    double power_;  // that passes, of one watt
};

}  // namespace fringe::oracle
