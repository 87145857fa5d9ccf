// What each figure of the thesis should show, against closed forms: the pattern alone is the picture minus
// the same picture without its gratings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optics/color.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

constexpr double kSlit = 1e-6;
constexpr double kPeriod = 2e-6;
constexpr double kBandRadius = 0.1;  // half the beam
constexpr std::array kWavelengths{450e-9, 550e-9, 700e-9};

// Linear sRGB, in which the thesis's values are stated.
double channel(const image::Pixel& pixel, int c) {
    static const glm::dmat3 toLinearSrgb = optics::linearSrgbFromXyz();
    return (toLinearSrgb * glm::dvec3(pixel.x, pixel.y, pixel.z))[c];
}

scene::Scene withoutGratings(scene::Scene scene) {
    std::erase_if(scene.lights, [](const scene::Light& light) {
        return std::holds_alternative<scene::ThesisGrating>(light.model);
    });
    return scene;
}

// The pattern on the back wall of a figure that looks straight at it.
class BackWall {
public:
    explicit BackWall(const char* figure) {
        const scene::Scene scene = sceneFile(std::string("scenes/thesis/") + figure);
        pattern_ = renderOnDevice(scene);
        const image::Image dark = renderOnDevice(withoutGratings(scene));
        for (std::size_t i = 0; i < pattern_.pixels.size(); ++i) {
            pattern_.pixels[i].x -= dark.pixels[i].x;
            pattern_.pixels[i].y -= dark.pixels[i].y;
            pattern_.pixels[i].z -= dark.pixels[i].z;
        }
        const double fov = std::get<scene::Perspective>(scene.camera.projection).fov.si;
        metresPerPixel_ = 2.0 * std::tan(0.5 * fov) * (scene.camera.position.z + 1.0) / scene.image.height;
    }

    double pitch() const { return metresPerPixel_; }

    // Value at a place on the wall, interpolated along x between the centres of pixels.
    double at(double x, double y, int c) const {
        const double column = 0.5 * pattern_.width + x / metresPerPixel_ - 0.5;
        const auto row = static_cast<std::uint32_t>(0.5 * pattern_.height - y / metresPerPixel_);
        const auto left = static_cast<std::uint32_t>(std::floor(column));
        const double t = column - left;
        return (1.0 - t) * channel(pattern_.at(left, row), c) + t * channel(pattern_.at(left + 1, row), c);
    }

    // Largest value of a channel in the rows whose height on the wall is at least `from` away from every
    // band.
    double outsideBands(const std::vector<double>& heights) const {
        double largest = 0.0;
        for (std::uint32_t row = 0; row < pattern_.height; ++row) {
            const double y = (0.5 * pattern_.height - row - 0.5) * metresPerPixel_;
            const bool inside = std::any_of(heights.begin(), heights.end(), [&](double height) {
                return std::abs(y - height) <= kBandRadius + metresPerPixel_;
            });
            // Columns of the back wall: beyond +-1 m the picture shows side walls, nearer and larger.
            for (std::uint32_t x = 0; x < pattern_.width && !inside; ++x) {
                if (std::abs((x + 0.5 - 0.5 * pattern_.width) * metresPerPixel_) > 0.99) continue;
                largest = std::max(largest, distance(pattern_.at(x, row), {}));
            }
        }
        return largest;
    }

private:
    image::Image pattern_;
    double metresPerPixel_;
};

const std::vector<double> kHeights{0.68, 0.34, 0.0, -0.34, -0.68};  // 1 to 5 slits

// Where on the wall, 1 m away, a sine of the angle from the normal falls.
double placeOf(double sine) {
    return sine / std::sqrt(1.0 - sine * sine);
}

// A value within half a pixel of a zero: the curvature there is (pi N / lambda)^2 times the peak N^2 at most,
// over (half a pixel, 1.7 mm on 1 m)^2, for N = 5: 0.05; for the single slit's own zero 2e-3.
double nearZero(int slits) {
    return 0.002 * slits * slits;
}

TEST(FiguresOnDevice, BandsAreNoHigherThanTheBeam) {
    for (const char* figure : {"figure-16.json", "figure-17.json"}) {
        EXPECT_LT(BackWall(figure).outsideBands(kHeights), 1e-6)
            << figure;  // rounding of a difference of two sums
    }
    EXPECT_LT(BackWall("figure-15.json").outsideBands({0.0}), 1e-6);
}

TEST(FiguresOnDevice, UnattenuatedBandsEndAbruptlyAndAttenuatedOnesFade) {
    const BackWall square("figure-16.json");
    const BackWall round("figure-17.json");
    for (double height : kHeights) {
        EXPECT_NEAR(square.at(0.0, height + 0.095, 1), 1.0, 1e-3);
        // 1 - (2 s/D)^2 at 0.8 of the beam's radius, to half a pixel of 3.4 mm.
        EXPECT_NEAR(round.at(0.0, height + 0.08, 1), 1.0 - 0.64, 0.035);
    }
}

TEST(FiguresOnDevice, TheMinimaOfTheSingleSlitAreSharedByAllSlitCounts) {
    const BackWall wall("figure-16.json");
    for (int c = 0; c < 3; ++c) {
        const double x = placeOf(kWavelengths[c] / kSlit);
        if (x > 0.97) continue;  // 700 nm: 980 mm, at the very edge of the wall
        for (int slits = 1; slits <= 5; ++slits) {
            EXPECT_LT(wall.at(x, kHeights[slits - 1], c), nearZero(slits)) << c << ", " << slits << " slits";
            EXPECT_LT(wall.at(-x, kHeights[slits - 1], c), nearZero(slits)) << c << ", " << slits << " slits";
        }
    }
}

TEST(FiguresOnDevice, PrincipalMaximaStandAtTheOrdersAndMinimaBetweenThem) {
    const BackWall wall("figure-16.json");
    for (int c = 0; c < 3; ++c) {
        const double first = kWavelengths[c] / kPeriod;  // sine of order 1
        for (int slits = 2; slits <= 5; ++slits) {
            const double y = kHeights[slits - 1];
            EXPECT_NEAR(wall.at(0.0, y, c), 1.0, 1e-6) << "order 0, clamped";
            EXPECT_NEAR(wall.at(placeOf(first), y, c), 1.0, 1e-6) << "order 1: sinc^2(1/2) N^2 > 1, clamped";
            // The array factor is zero at whole multiples of lambda / (N b) that are no order.
            for (int k = 1; k < slits; ++k) {
                EXPECT_LT(wall.at(placeOf(first * k / slits), y, c), nearZero(slits))
                    << c << " " << slits << " " << k;
            }
        }
    }
}

TEST(FiguresOnDevice, LongerWavelengthsSpreadWider) {
    const BackWall wall("figure-23.json");
    std::array<double, 3> halfWidth{};
    for (int c = 0; c < 3; ++c) {
        double x = 0.0;
        while (wall.at(x, kHeights[0], c) > 0.5 * wall.at(0.0, kHeights[0], c)) x += 0.1 * wall.pitch();
        halfWidth[c] = x;
        // sinc^2 is 1/2 at 0.4429 (as a tenth-pixel step finds it on pixels of 3.4 mm).
        EXPECT_NEAR(x, placeOf(0.4429 * kWavelengths[c] / kSlit), wall.pitch());
    }
    EXPECT_LT(halfWidth[0], halfWidth[1]);
    EXPECT_LT(halfWidth[1], halfWidth[2]);
}

TEST(FiguresOnDevice, OneChannelFiguresAddUpToTheThird) {
    const BackWall all("figure-23.json");
    const std::array figures{"figure-20.json", "figure-21.json", "figure-22.json"};
    for (int c = 0; c < 3; ++c) {
        const BackWall one(figures[c]);
        for (double x = -0.9; x < 0.9; x += 0.01) {
            EXPECT_NEAR(one.at(x, 0.34, c), all.at(x, 0.34, c), 1e-6);
            EXPECT_NEAR(one.at(x, 0.34, (c + 1) % 3), 0.0, 1e-6);
        }
    }
}

TEST(FiguresOnDevice, ThePatternGoesOnOnTheSideWall) {
    const scene::Scene scene = sceneFile("scenes/thesis/figure-24.json");
    const image::Image lit = renderOnDevice(scene);
    const image::Image dark = renderOnDevice(withoutGratings(scene));
    const auto brightest = [&](std::uint32_t from, std::uint32_t to) {
        double largest = 0.0;
        for (std::uint32_t y = 0; y < lit.height; ++y) {
            for (std::uint32_t x = from; x < to; ++x)
                largest = std::max(largest, distance(lit.at(x, y), dark.at(x, y)));
        }
        return largest;
    };
    EXPECT_GT(brightest(0, 40), 0.2);     // left wall
    EXPECT_GT(brightest(470, 600), 0.2);  // right wall
}

// In single precision the listing's angle near the main maximum is 0 or the root of a negative number
// (physics in docs/thesis-algorithm.md); mended, nothing is flagged.
TEST(FiguresOnDevice, TheStringOfArtifactsComesOfSinglePrecision) {
    const auto flagged = [](const char* figure) {
        const image::Image picture = renderOnDevice(sceneFile(std::string("scenes/thesis/") + figure));
        return std::count_if(picture.pixels.begin(), picture.pixels.end(),
                             [](const auto& p) { return p.nonFinite; });
    };
    EXPECT_GT(flagged("figure-25-artifacts.json"), 50);
    EXPECT_LT(flagged("figure-25-artifacts.json"), 500);
    EXPECT_EQ(flagged("figure-25.json"), 0);
}

}  // namespace
}  // namespace fringe::testing
