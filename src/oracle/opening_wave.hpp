// Light behind an opening (docs/theory.md): the same interface as SlitWave has.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "oracle/opening.hpp"
#include "oracle/ways.hpp"
#include "scene/scene.hpp"

namespace fringe::oracle {

class OpeningWave {
public:
    OpeningWave(const scene::Grating& grating, const OpeningShape& shape);

    struct View {
        std::optional<Opening> opening;  // nothing where no light gets
        std::optional<Ways> ways;        // in the near field, and in an uneven beam
        glm::dvec2 turn;                 // change of the direction cosines
        double geometry;                 // 1 / m^2: obliquity, cosine and inverse square
        double curvature;                // 1 / m: of the phase across the opening
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
    // Of the way past r less that past the middle. `incident`: the way the beam's axis goes.
    double wayPast(const glm::dvec2& r, const glm::dvec3& offset, const glm::dvec3& incident) const;

    OpeningShape shape_;
    scene::Beam beam_;
    std::optional<double> focus_;  // metres
    double area_;
    double extent_;
    double power_;  // that passes, of one watt
};

}  // namespace fringe::oracle
