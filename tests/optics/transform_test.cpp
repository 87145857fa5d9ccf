// Closed transforms against sums over the opening, against each other, and against worked values.
#include "optics/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "optics/integrals.hpp"
#include "optics/shapes.hpp"

namespace fringe::optics {
namespace {

using namespace units;
using glm::dvec2;
using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double kUm2 = 1e-12;

// Frequencies of directions in visible light, and much smaller and larger ones.
std::vector<dvec2> frequencies() {
    std::vector<dvec2> result{{0.0, 0.0}, {1e-6, 2e-6}, {1e5, 0.0}, {0.0, 1e5}, {1e5, 1e5}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const double scale : {1e-3, 1.0, 1e3, 1e4, 1e5, 1e6})
        for (int i = 0; i < 20; ++i) result.emplace_back(scale * uniform(random), scale * uniform(random));
    return result;
}

// Gauss quadrature over the parallelogram from `corner` along both vectors.
Complex overParallelogram(dvec2 corner, dvec2 first, dvec2 second, dvec2 f) {
    static const GaussRule rule = gaussLegendre(60);
    const double jacobian = 0.25 * std::abs(first.x * second.y - first.y * second.x);
    Complex sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const dvec2 at =
                corner + 0.5 * (1.0 + rule.nodes[i]) * first + 0.5 * (1.0 + rule.nodes[j]) * second;
            sum += jacobian * rule.weights[i] * rule.weights[j] *
                   std::polar(1.0, -2.0 * pi * (f.x * at.x + f.y * at.y));
        }
    }
    return sum;
}

// Gauss in the radius, equal steps around.
Complex overRing(double inner, double outer, dvec2 f) {
    static const GaussRule rule = gaussLegendre(60);
    constexpr int kAround = 200;
    Complex sum = 0.0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double radius = 0.5 * (outer + inner) + 0.5 * (outer - inner) * rule.nodes[i];
        for (int j = 0; j < kAround; ++j) {
            const double angle = 2.0 * pi * j / kAround;
            sum += 0.5 * (outer - inner) * rule.weights[i] * radius * 2.0 * pi / kAround *
                   std::polar(1.0, -2.0 * pi * radius * (f.x * std::cos(angle) + f.y * std::sin(angle)));
        }
    }
    return sum;
}

// What quadrature of 60 points, of at most 8 turns across, and the closed forms round off.
void expectSame(const Aperture& aperture, const Complex& expected, dvec2 f) {
    EXPECT_LT(std::abs(transform(aperture, f) - expected), 1e-13 * area(aperture)) << f.x << ' ' << f.y;
}

TEST(Transform, OfARectangle) {
    for (const dvec2 f : frequencies())
        expectSame(RectangularAperture{2 * um, 5 * um},
                   overParallelogram({-1e-6, -2.5e-6}, {2e-6, 0}, {0, 5e-6}, f), f);
}

TEST(Transform, OfARing) {
    for (const dvec2 f : frequencies()) {
        expectSame(CircularAperture{5 * um, 3 * um}, overRing(1.5e-6, 2.5e-6, f), f);
        expectSame(CircularAperture{5 * um, 0 * um}, overRing(0.0, 2.5e-6, f), f);
    }
}

// A hexagon is three rhombs.
TEST(Transform, OfAHexagon) {
    const PolygonalAperture hexagon = regularPolygon(6, 2e-6);
    for (const dvec2 f : frequencies()) {
        Complex sum = 0.0;
        for (int i = 0; i < 6; i += 2) {
            const auto vertex = static_cast<std::size_t>(i);
            sum += overParallelogram(dvec2(0.0), hexagon.vertices[vertex], hexagon.vertices[(vertex + 2) % 6],
                                     f);
        }
        expectSame(hexagon, sum, f);
    }
}

TEST(Transform, OfAPolygonThatIsNotConvex) {
    const PolygonalAperture polygon = ell();
    const dvec2 corner = polygon.vertices[0];
    for (const dvec2 f : frequencies()) {
        expectSame(polygon,
                   overParallelogram(corner, {4e-6, 0}, {0, 1e-6}, f) +
                       overParallelogram(corner + dvec2(0, 1e-6), {1e-6, 0}, {0, 3e-6}, f),
                   f);
    }
}

TEST(Transform, OfALatticeIsTheSumOfItsCells) {
    const LatticeAperture lattice{RectangularAperture{1 * um, 2 * um}, {3e-6, 0}, {1e-6, 2.5e-6}, 3, 4};
    for (const dvec2 f : frequencies()) {
        Complex sum = 0.0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 4; ++j)
                sum += overParallelogram(
                    (i - 1.0) * lattice.first + (j - 1.5) * lattice.second + dvec2(-0.5e-6, -1e-6), {1e-6, 0},
                    {0, 2e-6}, f);
        expectSame(lattice, sum, f);
    }
}

TEST(Transform, OfSlitsIsTheSumOfThem) {
    const Slits slits{5, 1 * um, 3 * um};
    for (const dvec2 f : frequencies()) {
        Complex sum = 0.0;
        for (int i = 0; i < 5; ++i)
            sum += overParallelogram({(i - 2.0) * 3e-6 - 0.5e-6, 0.0}, {1e-6, 0}, {0, 1.0}, {f.x, 0.0});
        expectSame(slits, sum, f);
    }
}

TEST(Transform, OfAMaskOfWholePixelsIsThatOfItsShape) {
    // An L in pixels of 0.5 um, in a frame that is centred on another point than its centroid.
    MaskAperture mask{10, 8, 0.5 * um, std::vector<float>(80, 0.0F)};
    for (std::uint32_t row = 0; row < 8; ++row)
        for (std::uint32_t column = 0; column < 8; ++column)
            if (row >= 6 || column < 2) mask.transmission[row * 10U + column] = 1.0F;
    const dvec2 corner(-2.5e-6, -2e-6);
    for (const dvec2 f : frequencies()) {
        expectSame(mask,
                   overParallelogram(corner, {4e-6, 0}, {0, 1e-6}, f) +
                       overParallelogram(corner + dvec2(0, 1e-6), {1e-6, 0}, {0, 3e-6}, f),
                   f);
    }
    for (float& transmission : mask.transmission) transmission *= 0.5F;
    EXPECT_NEAR(area(mask), 0.25 * 7e-12, 1e-26);                     // power
    EXPECT_NEAR(transform(mask, {0, 0}).real(), 0.5 * 7e-12, 1e-26);  // amplitude
}

// Worked with an independent program in double precision.
TEST(Transform, WorkedValues) {
    constexpr double kDigits = 5e-12 * kUm2;
    const PolygonalAperture hexagon = regularPolygon(6, 2e-6);
    EXPECT_NEAR(area(hexagon), 10.3923048454 * kUm2, 5e-11 * kUm2);
    EXPECT_LT(std::abs(transform(hexagon, {1.5e5, 2.5e5}) - 1.25682059869 * kUm2), kDigits);
    const PolygonalAperture triangle{{{0, 0}, {3e-6, 0}, {0, 2e-6}}};
    EXPECT_LT(std::abs(transform(triangle, {1e5, 2e5}) - Complex(0.241882802319, -2.58479244122) * kUm2),
              kDigits);
    EXPECT_LT(std::abs(transform(CircularAperture{3 * um, 0 * um}, {2e5, 1e5}) - 3.80695308130 * kUm2),
              kDigits);
    // sinc^2 of the slit times that of fifty slits, to the peak.
    const Slits slits{50, 0.5 * um, 1.6 * um};
    const double relative = std::norm(transform(slits, {0.34 / 550e-9, 0.0})) / std::norm(area(slits));
    EXPECT_NEAR(relative, 0.241212192878, 5e-13);
}

TEST(Transform, ManySidesMakeAnAiryPattern) {
    const PolygonalAperture polygon = regularPolygon(2000, 1.5e-6);
    const CircularAperture circle{3 * um, 0 * um};
    for (const dvec2 f : frequencies()) {
        // The polygon's area is less by 2 (pi/2000)^2/3 = 1.6e-6.
        EXPECT_LT(std::abs(transform(polygon, f) - transform(circle, f)), 2e-6 * area(circle));
    }
    // First zero of the Airy pattern (Born & Wolf 8.5.2).
    EXPECT_LT(std::abs(transform(circle, {1.2196699 / 3e-6, 0.0})), 1e-7 * area(circle));
}

TEST(Transform, PolygonsKeepTheirDigitsNextToTheirPeak) {
    // A = S - 2 pi^2 f.M.f + ...; what follows is of the third order, (2 pi f 4 um)^3/6.
    const PolygonalAperture polygon = ell();
    const Moments about = moments(polygon);
    for (const double scale : {1e-3, 1.0, 30.0, 300.0}) {
        const dvec2 f(scale, -0.3 * scale);
        const double series =
            about.area -
            2.0 * pi * pi * (f.x * f.x * about.xx + 2.0 * f.x * f.y * about.xy + f.y * f.y * about.yy);
        const double third = std::pow(2.0 * pi * scale * 4e-6, 3) / 6.0;
        EXPECT_LT(std::abs(transform(polygon, f) - series), (1e-15 + third) * about.area) << scale;
    }
}

TEST(Transform, MomentsAreThoseOfTheirShapes) {
    const Moments rectangle = moments(RectangularAperture{2 * um, 3 * um});
    EXPECT_NEAR(rectangle.area, 6e-12, 1e-26);
    EXPECT_NEAR(rectangle.xx, 8.0 * 3.0 / 12.0 * 1e-24, 1e-38);
    EXPECT_NEAR(rectangle.yy, 2.0 * 27.0 / 12.0 * 1e-24, 1e-38);
    const Moments polygon = moments(regularPolygon(2000, 1e-6)),
                  circle = moments(CircularAperture{2 * um, 0 * um});
    EXPECT_NEAR(polygon.xx / circle.xx, 1.0, 4e-6);  // the fourth power of the polygon's mean radius
    EXPECT_NEAR(polygon.xy / circle.xx, 0.0, 1e-12);
    // Two bars: their own products vanish, what is left is that of their centroids.
    const double centroid = (4.0 * 0.5 + 3.0 * 2.5) / 7.0;
    const double xy = 4.0 * (2.0 - centroid) * (0.5 - centroid) + 3.0 * (0.5 - centroid) * (2.5 - centroid);
    EXPECT_NEAR(moments(ell()).xy, xy * 1e-24, 1e-37);
}

}  // namespace
}  // namespace fringe::optics
