// A shape as the device got it, and by how much a ray or its surface would have to be shifted to make an
// answer of the device right.
#pragma once

#include "oracle/shapes.hpp"

namespace fringe::qualify {

class ShapeMeasure {
public:
    // From what the device gets (shaders/interface.h): duals are a half edge over its squared length.
    static ShapeMeasure ofPlane(const glm::dvec3& point, const glm::dvec3& normal);
    static ShapeMeasure ofRectangle(const glm::dvec3& center, const glm::dvec3& uDual,
                                    const glm::dvec3& vDual);
    static ShapeMeasure ofDisc(const glm::dvec3& center, const glm::dvec3& normal, double innerRadiusSquared,
                               double radiusSquared);
    static ShapeMeasure ofTriangle(const glm::dvec3& vertex, const glm::dvec3& edge1,
                                   const glm::dvec3& edge2);
    static ShapeMeasure ofSphere(const glm::dvec3& center, double radius);
    static ShapeMeasure ofBox(const glm::dvec3& center, const glm::dvec3& uDual, const glm::dvec3& vDual,
                              const glm::dvec3& wDual);
    static ShapeMeasure ofCylinder(const glm::dvec3& base, const glm::dvec3& axis, double height,
                                   double radius, bool capped);
    static ShapeMeasure ofCone(const glm::dvec3& apex, const glm::dvec3& axis, double height, double slope,
                               bool capped);

    // To the first hit; negative where there is none.
    double distance(const oracle::Ray& ray) const;

    // How far the hit at `got` lies off the surface, or how deep the ray has gone through what it hits at
    // `expected` and did not hit; either distance is negative where there is no hit. Relative to the largest
    // of the origin's distance from the shape's own origin, either distance and the shape's size.
    double shift(const oracle::Ray& ray, double got, double expected) const;

private:
    ShapeMeasure(scene::Shape shape, const glm::dvec3& origin, double size);

    bool isSolid() const;
    double missed(const oracle::Ray& ray, double got, double expected, double scale) const;

    scene::Shape shape_;
    glm::dvec3 origin_;
    double size_;  // of a plane 0
};

}  // namespace fringe::qualify
