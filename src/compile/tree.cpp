#include "compile/tree.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <span>

#include "compile/number.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;
using Leaves = std::span<TreeLeaf>;

// From here on leaves are halved by number, which bounds the depth whatever the scene looks like.
constexpr device::uint kDeepestHeuristic = 40;

struct Box {
    dvec3 low{std::numeric_limits<double>::infinity()};
    dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(dvec3 otherLow, dvec3 otherHigh) {
        low = glm::min(low, otherLow);
        high = glm::max(high, otherHigh);
    }
    double area() const {  // half of it
        const dvec3 size = high - low;
        return size.x * size.y + size.y * size.z + size.z * size.x;
    }
};

dvec3 middleOf(const TreeLeaf& leaf) {
    return 0.5 * (leaf.low + leaf.high);
}

Box boxOf(Leaves leaves) {
    Box box;
    for (const TreeLeaf& leaf : leaves) box.add(leaf.low, leaf.high);
    return box;
}

Box middlesOf(Leaves leaves) {
    Box box;
    for (const TreeLeaf& leaf : leaves) box.add(middleOf(leaf), middleOf(leaf));
    return box;
}

constexpr std::size_t kBins = 16;

// Equal slices of the interval in which the middles lie along an axis.
struct Slices {
    int axis;
    double low, high;

    std::size_t of(const TreeLeaf& leaf) const {
        const double place = (middleOf(leaf)[axis] - low) / (high - low) * double{kBins};
        return std::min(static_cast<std::size_t>(place), kBins - 1);
    }
};

struct Bin {
    Box box;
    std::size_t count = 0;

    void add(const Bin& other) {
        box.add(other.box.low, other.box.high);
        count += other.count;
    }
    double cost() const { return count == 0 ? 0.0 : static_cast<double>(count) * box.area(); }
};

struct Split {
    Slices slices;
    std::size_t first;  // slice on the right
    double cost;
};

std::optional<Split> bestSplitAlong(const Slices& slices, Leaves leaves) {
    std::array<Bin, kBins> bins;
    for (const TreeLeaf& leaf : leaves) {
        Bin& bin = bins[slices.of(leaf)];
        bin.box.add(leaf.low, leaf.high);
        ++bin.count;
    }
    std::array<double, kBins> costRight{};
    Bin right;
    for (std::size_t i = kBins - 1; i > 0; --i) {
        right.add(bins[i]);
        costRight[i] = right.cost();
    }
    std::optional<Split> best;
    Bin left;
    for (std::size_t i = 1; i < kBins; ++i) {
        left.add(bins[i - 1]);
        const double cost = left.cost() + costRight[i];
        if (left.count > 0 && left.count < leaves.size() && (!best || cost < best->cost))
            best = {slices, i, cost};
    }
    return best;
}

// Puts the leaves of the left child first and returns how many there are: at least one, and not all.
std::size_t divide(Leaves leaves, bool byHeuristic) {
    const Box middles = middlesOf(leaves);
    std::optional<Split> best;
    for (int axis = 0; axis < 3 && byHeuristic; ++axis) {
        if (!(middles.low[axis] < middles.high[axis])) continue;
        const auto split = bestSplitAlong({axis, middles.low[axis], middles.high[axis]}, leaves);
        if (split && (!best || split->cost < best->cost)) best = split;
    }
    if (best) {
        const auto isLeft = [&](const TreeLeaf& leaf) { return best->slices.of(leaf) < best->first; };
        return static_cast<std::size_t>(std::partition(leaves.begin(), leaves.end(), isLeft) -
                                        leaves.begin());
    }
    const dvec3 size = middles.high - middles.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = leaves.size() / 2;
    std::nth_element(
        leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(half), leaves.end(),
        [axis](const TreeLeaf& a, const TreeLeaf& b) { return middleOf(a)[axis] < middleOf(b)[axis]; });
    return half;
}

class Builder {
public:
    explicit Builder(Leaves leaves) {
        tree_.nodes.reserve(leaves.size());
        if (leaves.size() > 1) build(leaves, 1);
    }

    Tree take() { return std::move(tree_); }

private:
    // `depth` counts the nodes from the root to this one. Returns what a parent says of it.
    device::uint build(Leaves leaves, device::uint depth) {
        if (leaves.size() == 1) {
            const TreeLeaf& leaf = leaves.front();
            assert(leaf.kind < 8 && leaf.index < 1U << device::TREE_KIND_SHIFT);
            return device::TREE_LEAF | leaf.kind << device::TREE_KIND_SHIFT | leaf.index;
        }
        tree_.depth = std::max(tree_.depth, depth);
        const std::size_t node = tree_.nodes.size();
        tree_.nodes.emplace_back();
        const std::size_t half = divide(leaves, depth < kDeepestHeuristic);
        const Box left = boxOf(leaves.first(half)), right = boxOf(leaves.subspan(half));
        device::TreeNode packed{};
        packed.lowLeft = toFloat(left.low);
        packed.highLeft = toFloat(left.high);
        packed.lowRight = toFloat(right.low);
        packed.highRight = toFloat(right.high);
        packed.left = build(leaves.first(half), depth + 1);
        packed.right = build(leaves.subspan(half), depth + 1);
        tree_.nodes[node] = packed;
        return count(node);
    }

    Tree tree_;
};

}  // namespace

Tree buildTree(std::vector<TreeLeaf> leaves) {
    const Box whole = boxOf(leaves);
    const dvec3 size = glm::max(glm::abs(whole.low), glm::abs(whole.high));
    const double margin = 4e-6 * std::max({size.x, size.y, size.z});
    for (TreeLeaf& leaf : leaves) {
        leaf.low -= margin;
        leaf.high += margin;
    }
    return Builder(leaves).take();
}

}  // namespace fringe::compile
