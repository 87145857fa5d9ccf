#include "compile/grating_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <map>
#include <span>

#include "compile/extent.hpp"
#include "compile/number.hpp"

namespace fringe::compile {
namespace {

using glm::dvec3;
using Indices = std::vector<device::uint>;

constexpr double kMargin =
    1e-5;  // of the largest coordinate, around every cell: far beyond the rounding of a point

constexpr std::size_t kMostGridCells = std::size_t{1} << 18;  // 64 to a side, where a room is a cube
constexpr std::size_t kMostEntries = std::size_t{1} << 22;    // of all lists: exact as floats, 16 MiB

// Something matt: its box, and its plane if it is flat.
struct Receiver {
    std::array<Interval, 3> box;
    std::optional<FlatPlane> plane;

    bool touches(const Region& region) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (box[axis].low > region.high[axis] || box[axis].high < region.low[axis]) return false;
        }
        if (!plane) return true;
        double low = 0.0, high = 0.0;  // of the distances from the plane
        for (int axis = 0; axis < 3; ++axis) {
            const double along = plane->normal[axis];
            if (along == 0.0) continue;
            const double a = along * (region.low[axis] - plane->point[axis]);
            const double b = along * (region.high[axis] - plane->point[axis]);
            low += std::min(a, b);
            high += std::max(a, b);
        }
        return low <= 0.0 && high >= 0.0;
    }
};

std::vector<Receiver> receiversOf(const scene::Scene& scene) {
    std::vector<Receiver> receivers;
    for (const scene::Object& object : scene.objects) {
        const auto& model = scene.materials[object.material].model;
        // The back of an optical disc is matt.
        if (!std::holds_alternative<scene::Diffuse>(model) &&
            !std::holds_alternative<scene::OpticalDisc>(model))
            continue;
        Receiver receiver{{}, planeOf(object.shape)};
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 along(0.0);
            along[axis] = 1.0;
            receiver.box[axis] = extentAlong(object.shape, along);
        }
        receivers.push_back(receiver);
    }
    return receivers;
}

// Even cells along the axes. Where the scene has infinite planes those at the rim reach to infinity.
struct Cells {
    dvec3 low, size;
    std::array<device::uint, 3> counts{1, 1, 1};
    bool areOpen = false;
    double margin = 0.0;

    std::size_t all() const { return std::size_t{counts[0]} * counts[1] * counts[2]; }
};

Cells cellsFor(const std::vector<Receiver>& receivers, const GratingReach& gratings, std::size_t mostCells) {
    Cells cells;
    dvec3 low(kInfinity), high(-kInfinity);
    for (const Receiver& receiver : receivers) {
        for (int axis = 0; axis < 3; ++axis) {
            const Interval side = receiver.box[axis];
            if (std::isfinite(side.low)) low[axis] = std::min(low[axis], side.low);
            if (std::isfinite(side.high)) high[axis] = std::max(high[axis], side.high);
            cells.areOpen = cells.areOpen || std::isinf(side.low) || std::isinf(side.high);
        }
    }
    if (cells.areOpen) {
        for (device::uint i = 0; i < gratings.count(); ++i) {
            low = glm::min(low, gratings.position(i));
            high = glm::max(high, gratings.position(i));
        }
    }
    const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-6});
    const dvec3 corner = glm::max(glm::abs(low), glm::abs(high));
    cells.margin = kMargin * std::max({corner.x, corner.y, corner.z, longest});
    const double around = cells.margin + (cells.areOpen ? longest : 0.0);
    low -= around;
    high += around;
    // As many as there may be, of equal edges: a flat scene has but one along its thickness.
    const dvec3 extent = high - low;
    double edge = std::cbrt(extent.x * extent.y * extent.z / static_cast<double>(mostCells));
    for (;; edge *= 1.05) {
        for (int axis = 0; axis < 3; ++axis) {
            const double wanted = std::clamp(std::ceil(extent[axis] / edge), 1.0, 1024.0);
            cells.counts[axis] = static_cast<device::uint>(wanted);
        }
        if (cells.all() <= mostCells) break;
    }
    cells.low = low;
    for (int axis = 0; axis < 3; ++axis) cells.size[axis] = extent[axis] / cells.counts[axis];
    return cells;
}

// Cells from..to-1 along each axis.
struct Block {
    std::array<device::uint, 3> from, to;
};

Region regionOf(const Block& block, const Cells& cells) {
    Region region;
    for (int axis = 0; axis < 3; ++axis) {
        region.low[axis] = cells.low[axis] + block.from[axis] * cells.size[axis] - cells.margin;
        region.high[axis] = cells.low[axis] + block.to[axis] * cells.size[axis] + cells.margin;
        if (!cells.areOpen) continue;
        if (block.from[axis] == 0) region.low[axis] = -kInfinity;
        if (block.to[axis] == cells.counts[axis]) region.high[axis] = kInfinity;
    }
    return region;
}

Indices upTo(std::size_t size) {
    Indices all;
    for (std::size_t i = 0; i < size; ++i) all.push_back(count(i));
    return all;
}

// Halves the grid again and again, as long as there is something matt in a part and a grating that may reach
// it.
class Descent {
public:
    // What is told of a cell: its number, its region and the gratings, in their order.
    using Visit = std::function<void(std::size_t, const Region&, const Indices&)>;

    Descent(const Cells& cells, const std::vector<Receiver>& receivers, const GratingReach& gratings,
            Visit visit)
        : cells_(cells), receivers_(receivers), gratings_(gratings), visit_(std::move(visit)) {}

    void run() const { divide({{0, 0, 0}, cells_.counts}, upTo(receivers_.size()), upTo(gratings_.count())); }

private:
    void divide(const Block& block, const Indices& receivers, const Indices& gratings) const {
        const Region region = regionOf(block, cells_);
        Indices touched, reaching;
        for (const device::uint i : receivers)
            if (receivers_[i].touches(region)) touched.push_back(i);
        if (touched.empty()) return;
        for (const device::uint i : gratings)
            if (gratings_.mayReach(i, region)) reaching.push_back(i);
        if (reaching.empty()) return;
        std::array<device::uint, 3> sizes{};
        for (int axis = 0; axis < 3; ++axis) sizes[axis] = block.to[axis] - block.from[axis];
        const auto axis =
            static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
        if (sizes[axis] == 1) {
            const std::size_t layer = std::size_t{cells_.counts[0]} * cells_.counts[1];
            visit_(block.from[0] + block.from[1] * std::size_t{cells_.counts[0]} + block.from[2] * layer,
                   region, reaching);
            return;
        }
        const device::uint middle = block.from[axis] + sizes[axis] / 2;
        Block half = block;
        half.to[axis] = middle;
        divide(half, touched, reaching);
        half = block;
        half.from[axis] = middle;
        divide(half, touched, reaching);
    }

    const Cells& cells_;
    const std::vector<Receiver>& receivers_;
    const GratingReach& gratings_;
    Visit visit_;
};

// The lists of all cells, each different one once.
struct Lists {
    std::vector<float> places;   // of each cell's list
    std::vector<float> entries;  // of a list, its length and the gratings
};

Lists listsOf(const Cells& cells, const std::vector<Receiver>& receivers, const GratingReach& gratings) {
    Lists lists{std::vector<float>(cells.all(), 0.0F), {0.0F}};  // the empty list first
    std::map<Indices, float> known;
    Descent(cells, receivers, gratings, [&](std::size_t cell, const Region&, const Indices& reaching) {
        const auto [place, isNew] = known.try_emplace(reaching, static_cast<float>(lists.entries.size()));
        if (isNew) {
            lists.entries.push_back(static_cast<float>(reaching.size()));
            for (const device::uint i : reaching) lists.entries.push_back(static_cast<float>(i));
        }
        lists.places[cell] = place->second;
    }).run();
    return lists;
}

}  // namespace

bool hasManyGratings(const CompiledScene& scene) {
    const std::array sizes{scene.gratings.size(), scene.slitGratings.size(), scene.openingGratings.size()};
    return std::any_of(sizes.begin(), sizes.end(), [](std::size_t size) { return size > device::FEW; }) ||
           sizes[0] + sizes[1] + sizes[2] > device::FEW_GRATINGS;
}

void addGratingGrid(const scene::Scene& scene, CompiledScene& out) {
    if (!hasManyGratings(out)) return;
    const GratingReach gratings(out);
    const std::vector<Receiver> receivers = receiversOf(scene);
    if (receivers.empty()) return;
    Cells cells;
    Lists lists;
    for (std::size_t most = kMostGridCells;; most /= 8) {
        cells = cellsFor(receivers, gratings, most);
        lists = listsOf(cells, receivers, gratings);
        if (lists.entries.size() <= kMostEntries || most < 8) break;
    }
    device::GratingGrid& grid = out.frame.gratingGrid;
    grid.low = toFloat(cells.low);
    grid.cellsPerMetre = toFloat(1.0 / cells.size);
    grid.last = {toFloat(cells.counts[0] - 1.0), toFloat(cells.counts[1] - 1.0),
                 toFloat(cells.counts[2] - 1.0)};
    grid.perRow = cells.counts[0];
    grid.perLayer = cells.counts[0] * cells.counts[1];
    grid.places = count(out.tables.size());
    grid.lists = count(out.tables.size() + lists.places.size());
    out.tables.insert(out.tables.end(), lists.places.begin(), lists.places.end());
    out.tables.insert(out.tables.end(), lists.entries.begin(), lists.entries.end());
}

std::vector<Region> litRegions(const scene::Scene& scene, const CompiledScene& compiled,
                               std::size_t mostCells) {
    const GratingReach gratings(compiled);
    const std::vector<Receiver> receivers = receiversOf(scene);
    std::vector<Region> regions;
    if (receivers.empty() || gratings.count() == 0) return regions;
    const Cells cells = cellsFor(receivers, gratings, mostCells);
    Descent(cells, receivers, gratings, [&](std::size_t, const Region& region, const Indices&) {
        regions.push_back(region);
    }).run();
    return regions;
}

}  // namespace fringe::compile
