// Scenes of many shapes: the tree holds each shape once, inside its boxes, and changes how fast a picture is
// and nothing else.
#include "compile/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>

#include "render/random.hpp"
#include "render/rendering.hpp"

namespace fringe::testing {
namespace {

using compile::Tree;
using compile::TreeLeaf;
using glm::dvec3;

// ---- the tree itself -----------------------------------------------------------------------------

std::vector<TreeLeaf> randomLeaves(std::size_t count, double extent, double size) {
    Random random(7);
    std::vector<TreeLeaf> leaves;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 low = random.point(extent);
        leaves.push_back({3, static_cast<device::uint>(i), low, low + size * random.between(0.1, 1.0)});
    }
    return leaves;
}

struct Walk {
    const Tree& tree;
    std::map<device::uint, int> visits;  // of each leaf
    device::uint deepest = 0;

    void child(device::uint at, glm::vec3 low, glm::vec3 high, const std::vector<TreeLeaf>& leaves,
               device::uint depth) {
        deepest = std::max(deepest, depth);
        if ((at & device::TREE_LEAF) == 0) {
            const device::TreeNode& node = tree.nodes.at(at);
            for (int i = 0; i < 3; ++i) {
                EXPECT_LE(low[i], std::min(node.lowLeft[i], node.lowRight[i]));
                EXPECT_GE(high[i], std::max(node.highLeft[i], node.highRight[i]));
            }
            child(node.left, node.lowLeft, node.highLeft, leaves, depth + 1);
            child(node.right, node.lowRight, node.highRight, leaves, depth + 1);
            return;
        }
        const device::uint index = at & ((1U << device::TREE_KIND_SHIFT) - 1);
        EXPECT_EQ((at & ~device::TREE_LEAF) >> device::TREE_KIND_SHIFT, 3U);
        ++visits[index];
        for (int i = 0; i < 3; ++i) {
            EXPECT_LT(low[i], leaves.at(index).low[i]);
            EXPECT_GT(high[i], leaves.at(index).high[i]);
        }
    }
};

void expectEveryLeafOnce(const std::vector<TreeLeaf>& leaves) {
    const Tree tree = compile::buildTree(leaves);
    ASSERT_EQ(tree.nodes.size(), leaves.size() - 1);
    Walk walk{tree, {}};
    walk.child(0, glm::vec3(-1e30F), glm::vec3(1e30F), leaves, 0);
    EXPECT_EQ(walk.visits.size(), leaves.size());
    for (const auto& [leaf, visits] : walk.visits) EXPECT_EQ(visits, 1) << leaf;
    EXPECT_EQ(walk.deepest, tree.depth);
    EXPECT_LT(tree.depth, 70U);  // 40 by the heuristic, then halves of at most 2^28 leaves
}

TEST(Tree, HoldsEveryShapeOnceInsideItsBoxes) {
    for (const std::size_t count : {2, 3, 17, 1000}) expectEveryLeafOnce(randomLeaves(count, 1.0, 0.1));
}

TEST(Tree, HoldsShapesThatLieInTheSamePlace) {
    std::vector<TreeLeaf> leaves;
    for (device::uint i = 0; i < 100; ++i) leaves.push_back({3, i, dvec3(1.0), dvec3(2.0)});
    expectEveryLeafOnce(leaves);
}

// Each shape half as large and as far as the last: every split cuts off one, until the heuristic ends.
TEST(Tree, IsBoundedInDepthWhereSizesDiffer) {
    std::vector<TreeLeaf> leaves;
    double place = 1.0;
    for (device::uint i = 0; i < 200; ++i, place *= 0.5)
        leaves.push_back({3, i, dvec3(place), dvec3(1.1 * place)});
    expectEveryLeafOnce(leaves);
}

TEST(Tree, IsNoneForFewerThanTwoShapes) {
    EXPECT_TRUE(compile::buildTree({}).nodes.empty());
    EXPECT_TRUE(compile::buildTree(randomLeaves(1, 1.0, 0.1)).nodes.empty());
}

// ---- pictures ------------------------------------------------------------------------------------

// Forty of each shape that has a box over the floor and in the light of primitives.json, an eighth of them of
// glass and of metal; and two in the same place, of which the first is to be seen.
scene::Scene crowd() {
    scene::Scene scene = sceneFile("tests/render/primitives.json");
    Random random(7);
    const auto add = [&](const scene::Shape& shape) {
        constexpr std::array kMaterials{"red", "grey", "red", "glass", "grey", "red", "grey", "gold"};
        const auto* name = kMaterials.at(scene.objects.size() % kMaterials.size());
        const auto material = std::find_if(scene.materials.begin(), scene.materials.end(),
                                           [&](const scene::Material& m) { return m.name == name; });
        scene.objects.push_back({{}, shape, static_cast<std::uint32_t>(material - scene.materials.begin())});
    };
    for (int i = 0; i < 40; ++i) {
        const dvec3 p = dvec3(0.0, 0.8, -0.5) + random.point(0.8) * dvec3(2.0, 1.0, 1.0);
        const dvec3 a = glm::normalize(random.point(1.0) + dvec3(0.0, 0.0, 1.5));
        const dvec3 u = glm::normalize(glm::cross(a, dvec3(0.0, 1.0, 0.0)));
        const dvec3 v = glm::cross(a, u);
        const double r = random.between(0.03, 0.12);
        add(scene::Rectangle{p, r * u, r * v});
        add(scene::Disc{random.point(1.0) + dvec3(0, 1, -1), a, r, 0.3 * r});
        add(scene::Sphere{random.point(1.0) + dvec3(0, 1, -1), r});
        add(scene::Box{random.point(1.0) + dvec3(0, 1, -1), r * u, 0.5 * r * v, 0.7 * r * a});
        add(scene::Cylinder{p, p + 2.0 * r * a, 0.5 * r, i % 2 == 0});
        add(scene::Cone{p + a, p + a + 2.0 * r * u, r, i % 2 == 0});
        add(scene::Triangle{{p, p + 2.0 * r * u, p + 2.0 * r * v}});
    }
    const scene::Shape twice = scene::Sphere{{0.3, 0.7, 1.4}, 0.15};
    add(twice);
    add(twice);
    return scene;
}

std::size_t pixelsBeyond(const image::Image& a, const image::Image& b, double tolerance) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
        if (!(distance(a.pixels[i], b.pixels[i]) <= tolerance)) ++beyond;
    }
    return beyond;
}

constexpr auto kLoop = [](device::Specialisation& constants) { constants.TREE_DEPTH = 0; };

TEST(TreeOnDevice, GivesThePictureOfTheLoopOverAllBitForBit) {
    const scene::Scene scene = crowd();
    EXPECT_EQ(pixelsBeyond(renderOnDevice(scene), renderOnDevice(scene, {.change = kLoop}), 0.0), 0U);
}

// As on devices whose texel buffers are too small.
TEST(TreeOnDevice, GivesTheSamePictureFromAnImageBitForBit) {
    const scene::Scene scene = crowd();
    EXPECT_EQ(pixelsBeyond(renderOnDevice(scene), renderOnDevice(scene, {.change = texelsInImages}), 0.0),
              0U);
}

// Its nodes are more texels than the 65,536 that Vulkan promises of a texel buffer, and SwiftShader has; and
// many rows of an image.
TEST(TreeOnDevice, RendersMoreShapesThanSmallTexelBuffersHold) {
    scene::Scene scene = sceneFile("tests/render/primitives.json");
    scene.image.width = scene.image.height = 64;
    scene.objects.erase(scene.objects.begin() + 1, scene.objects.end());  // leaves the floor
    Random random(7);
    for (int i = 0; i < 20'000; ++i) {
        const dvec3 p = dvec3(0, 0.8, -0.5) + random.point(0.8) * dvec3(2, 1, 1);
        scene.objects.push_back({{}, scene::Sphere{p, random.between(0.005, 0.02)}, 0});
    }
    const image::Image picture = renderOnDevice(scene);
    EXPECT_TRUE(std::any_of(picture.pixels.begin(), picture.pixels.end(),
                            [](const image::Pixel& pixel) { return pixel.y > 0.0F; }));
    EXPECT_EQ(pixelsBeyond(picture, renderOnDevice(scene, {.change = texelsInImages}), 0.0), 0U);
}

// 1e-3 of the pixels at most differ, on silhouettes, and 2e-4 is what reference_test.cpp allows these shapes.
TEST(TreeOnDevice, AgreesWithTheReference) {
    const scene::Scene scene = crowd();
    const image::Image device = renderOnDevice(scene);
    EXPECT_LT(pixelsBeyond(device, renderReference(scene), 2e-4), device.pixels.size() / 100);
}

// The seventeenth sphere, behind the camera, is what makes a tree of sixteen that were looked at in turn.
TEST(TreeOnDevice, GivesThePictureOfTheUnrolledLoopOverFew) {
    scene::Scene scene = sceneFile("tests/render/primitives.json");
    Random random(7);
    while (std::count_if(scene.objects.begin(), scene.objects.end(), [](const scene::Object& object) {
               return std::holds_alternative<scene::Sphere>(object.shape);
           }) < 16) {
        scene.objects.push_back({{}, scene::Sphere{random.point(0.8) + dvec3(0, 0.8, 0), 0.1}, 0});
    }
    const image::Image few = renderOnDevice(scene);
    scene.objects.push_back({{}, scene::Sphere{{0.0, 1.2, 9.0}, 0.1}, 0});
    EXPECT_LE(pixelsBeyond(few, renderOnDevice(scene), 1e-4), few.pixels.size() / 1000);
}

}  // namespace
}  // namespace fringe::testing
