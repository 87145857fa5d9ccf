// Rays against shapes. What is judged is not the distance, which a grazing ray leaves open, but the least
// shift of the ray or the surface that would make the answer right: how far the hit point lies off the
// surface, and how deep the ray has gone through what it did not hit. In units of the largest length in play:
// the origin's distance from the shape's own origin, the way to the hit, the shape's size.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "oracle/frame.hpp"
#include "qualify/cases.hpp"
#include "qualify/shape_measure.hpp"
#include "shaders/stress_shapes.comp.h"

namespace fringe::qualify {
namespace {

using glm::dvec3;
using Inputs = std::span<const float>;

enum class Kind : std::uint32_t {
    plane,
    rectangle,
    disc,
    triangle,
    sphere,
    box,
    openCylinder,
    cylinder,
    openCone,
    cone
};

// Of any direction, or along an axis, or a rounding away from one.
dvec3 anyOrAxis(Draw& draw) {
    if (!draw.oneIn(4)) return draw.direction();
    dvec3 direction(0.0);
    direction[static_cast<int>(draw.below(3))] = draw.sign();
    if (draw.oneIn(2))
        direction[static_cast<int>(draw.below(3))] += draw.sign() * draw.magnitude(1e-44, 1e-3);
    return glm::normalize(direction);
}

// A ray at a shape of this size about `middle`: from afar, from near by, from within, from its surface; at
// its middle, past its rim, along its surface. `frame` has the shape's axes.
void drawRay(Draw& draw, std::span<float> inputs, const dvec3& middle, const dvec3& halfSize,
             const oracle::Frame& frame) {
    const double size = std::max({halfSize.x, halfSize.y, halfSize.z});
    const auto inShape = [&](double share) {
        const dvec3 place(draw.between(-share, share), draw.between(-share, share),
                          draw.between(-share, share));
        return middle + frame.toWorld(place * halfSize);
    };
    dvec3 target = inShape(1.1);
    if (draw.oneIn(4)) {
        // A point of the rim, of an edge or of a corner.
        dvec3 place(draw.sign(), draw.sign(), draw.sign());
        place[static_cast<int>(draw.below(3))] = draw.between(-1.0, 1.0);
        target = middle + frame.toWorld(place * halfSize);
    }
    dvec3 origin = target + size * draw.magnitude(1e-3, 1e3) * draw.direction();
    if (draw.oneIn(4)) origin = inShape(1.0);
    dvec3 direction = glm::normalize(target - origin);
    if (draw.oneIn(4)) direction = anyOrAxis(draw);
    if (draw.oneIn(6)) {
        // Along one of the shape's planes, at a slope of next to nothing.
        dvec3 local(draw.between(-1.0, 1.0), draw.between(-1.0, 1.0), draw.between(-1.0, 1.0));
        local[static_cast<int>(draw.below(3))] *= draw.oneIn(3) ? 0.0 : draw.magnitude(1e-40, 1e-2);
        direction = frame.toWorld(glm::normalize(local));
    }
    put(inputs, 0, origin);
    put(inputs, 3, direction);
}

// The scene's own size goes from micrometres to megametres, and the shape is up to a million times as far
// from the world's origin as it is large.
struct Placed {
    double size;
    dvec3 place;
    oracle::Frame frame;
};

Placed placed(Draw& draw) {
    const double size = draw.magnitude(1e-6, 1e6);
    const dvec3 place = draw.oneIn(3) ? dvec3(0.0) : size * draw.magnitude(1e-2, 1e5) * draw.direction();
    return {size, place, oracle::Frame::around(anyOrAxis(draw))};
}

// Slender to even.
double share(Draw& draw) {
    return draw.oneIn(4) ? draw.magnitude(1e-4, 1.0) : draw.between(0.2, 1.0);
}

template <Kind kind>
void drawShape(Draw& draw, std::span<float> inputs) {
    const auto [size, place, frame] = placed(draw);
    put(inputs, 6, place);
    const dvec3 half = size * dvec3(1.0, share(draw), share(draw));
    dvec3 middle = place, extent = half;
    if (kind == Kind::plane || kind == Kind::disc) {
        put(inputs, 9, frame.z);
        extent = size * dvec3(1.0, 1.0, 0.0);
        if (kind == Kind::disc) {
            const double hole = draw.oneIn(2) ? 0.0 : draw.between(0.0, 0.99);
            inputs[12] = static_cast<float>(hole * hole * size * size);
            inputs[13] = static_cast<float>(size * size);
        }
    } else if (kind == Kind::rectangle || kind == Kind::box) {
        put(inputs, 9, frame.x / half.x);
        put(inputs, 12, frame.y / half.y);
        if (kind == Kind::box) put(inputs, 15, frame.z / half.z);
        else extent.z = 0.0;
    } else if (kind == Kind::triangle) {
        // The third corner lies anywhere beside the first edge, slivers included.
        const dvec3 u = half.x * frame.x, v = draw.between(-1.0, 1.0) * half.x * frame.x + half.y * frame.y;
        put(inputs, 9, u);
        put(inputs, 12, v);
        put(inputs, 15, frame.z);
        middle = place + (u + v) / 3.0;
        extent.z = 0.0;
    } else if (kind == Kind::sphere) {
        inputs[9] = static_cast<float>(size);
        extent = dvec3(size);
    } else {
        put(inputs, 9, frame.z);
        const double radius = half.y;
        inputs[12] = static_cast<float>(size);
        inputs[13] = static_cast<float>(kind >= Kind::openCone ? radius / size : radius);
        middle = place + 0.5 * size * frame.z;
        extent = dvec3(radius, radius, 0.5 * size);
    }
    drawRay(draw, inputs, middle, extent, frame);
}

// The shape that these floats are.
template <Kind kind>
ShapeMeasure measured(Inputs in) {
    const dvec3 place = at(in, 6);
    if constexpr (kind == Kind::plane) return ShapeMeasure::ofPlane(place, at(in, 9));
    else if constexpr (kind == Kind::rectangle)
        return ShapeMeasure::ofRectangle(place, at(in, 9), at(in, 12));
    else if constexpr (kind == Kind::disc) return ShapeMeasure::ofDisc(place, at(in, 9), in[12], in[13]);
    else if constexpr (kind == Kind::triangle) return ShapeMeasure::ofTriangle(place, at(in, 9), at(in, 12));
    else if constexpr (kind == Kind::sphere) return ShapeMeasure::ofSphere(place, in[9]);
    else if constexpr (kind == Kind::box)
        return ShapeMeasure::ofBox(place, at(in, 9), at(in, 12), at(in, 15));
    else if constexpr (kind == Kind::openCylinder || kind == Kind::cylinder)
        return ShapeMeasure::ofCylinder(place, at(in, 9), in[12], in[13], kind == Kind::cylinder);
    else return ShapeMeasure::ofCone(place, at(in, 9), in[12], in[13], kind == Kind::cone);
}

template <Kind kind>
Judgement judgeShape(Inputs in, Inputs results) {
    const ShapeMeasure shape = measured<kind>(in);
    const oracle::Ray ray{at(in, 0), at(in, 3)};
    const double expected = shape.distance(ray);
    const float got = results[0];
    const bool both = got > 0.0F && expected > 0.0;
    return {shape.shift(ray, got, expected), both ? ulpsBetween(got, expected) : 0.0, got, expected};
}

template <Kind kind>
StressCase shapeCase(std::string_view name, std::string_view function, std::vector<std::string_view> own) {
    std::vector<std::string_view> inputs{"ox", "oy", "oz", "dx", "dy", "dz", "x", "y", "z"};
    inputs.insert(inputs.end(), own.begin(), own.end());
    return {name,
            function,
            4e-6,
            "a ray leaves a surface by 4e-6 of its coordinates (leave() of trace.glsl)",
            stress_shapes_comp,
            static_cast<std::uint32_t>(kind),
            inputs,
            1,
            drawShape<kind>,
            judgeShape<kind>,
            kFullCount};
}

}  // namespace

std::vector<StressCase> shapeCases() {
    const std::vector<std::string_view> round{"axis_x", "axis_y", "axis_z", "height", "radius"},
        conical{"axis_x", "axis_y", "axis_z", "height", "slope"};
    return {
        shapeCase<Kind::plane>("plane", "hitPlane, shapes.glsl", {"nx", "ny", "nz"}),
        shapeCase<Kind::rectangle>("rectangle-hit", "hitRectangle, shapes.glsl",
                                   {"ux", "uy", "uz", "vx", "vy", "vz"}),
        shapeCase<Kind::disc>("disc", "hitDisc, shapes.glsl",
                              {"nx", "ny", "nz", "inner_squared", "radius_squared"}),
        shapeCase<Kind::triangle>("triangle", "hitTriangle, shapes.glsl",
                                  {"e1x", "e1y", "e1z", "e2x", "e2y", "e2z", "nx", "ny", "nz"}),
        shapeCase<Kind::sphere>("sphere", "hitSphere, shapes.glsl", {"radius"}),
        shapeCase<Kind::box>("box", "hitBox, shapes.glsl",
                             {"ux", "uy", "uz", "vx", "vy", "vz", "wx", "wy", "wz"}),
        shapeCase<Kind::openCylinder>("open-cylinder", "hitCylinder, shapes.glsl", round),
        shapeCase<Kind::cylinder>("cylinder", "hitCylinder, shapes.glsl", round),
        shapeCase<Kind::openCone>("open-cone", "hitCone, shapes.glsl", conical),
        shapeCase<Kind::cone>("cone", "hitCone, shapes.glsl", conical),
    };
}

}  // namespace fringe::qualify
