#include "compile/table_memo.hpp"

#include <variant>

namespace fringe::compile {
namespace {

using units::m;

// Writes a shape's numbers, of a sequence its length first.
struct ShapeWriter {
    TableMemo::Key& key;

    void operator()(const optics::Slits& a) const { key.add(a.count).add(a.width / m).add(a.period / m); }
    void operator()(const optics::RectangularAperture& a) const { key.add(a.width / m).add(a.height / m); }
    void operator()(const optics::CircularAperture& a) const {
        key.add(a.diameter / m).add(a.innerDiameter / m);
    }
    void operator()(const optics::PolygonalAperture& a) const {
        key.add(static_cast<double>(a.vertices.size()));
        for (const glm::dvec2& vertex : a.vertices) key.add(vertex.x).add(vertex.y);
    }
    void operator()(const optics::LatticeAperture& a) const {
        key.add(static_cast<double>(a.cell.index()));
        std::visit(*this, a.cell);
        key.add(a.first.x).add(a.first.y).add(a.second.x).add(a.second.y);
        key.add(a.firstCount).add(a.secondCount);
    }
    void operator()(const optics::MaskAperture& a) const {
        key.add(a.columns).add(a.rows).add(a.pixel / m).add(a.transmission);
    }
};

}  // namespace

TableMemo::Key& TableMemo::Key::add(double value) {
    numbers_.push_back(value);
    return *this;
}

TableMemo::Key& TableMemo::Key::add(const optics::Curve& curve) {
    numbers_.push_back(static_cast<double>(curve.size()));
    for (const optics::Knot& knot : curve) add(knot.wavelength_nm).add(knot.value);
    return *this;
}

TableMemo::Key& TableMemo::Key::add(const optics::Spectrum& spectrum) {
    add(spectrum.density).add(static_cast<double>(spectrum.lines.size()));
    for (const optics::Line& line : spectrum.lines)
        add(line.wavelength / units::nm).add(line.power).add(line.width / units::nm);
    return *this;
}

TableMemo::Key& TableMemo::Key::add(std::span<const float> values) {
    numbers_.push_back(static_cast<double>(values.size()));
    numbers_.insert(numbers_.end(), values.begin(), values.end());
    return *this;
}

TableMemo::Key& TableMemo::Key::add(const optics::Aperture& aperture) {
    add(-1.0 - static_cast<double>(aperture.index()));  // no key of slits begins so
    std::visit(ShapeWriter{*this}, aperture);
    return *this;
}

TableMemo::Key& TableMemo::Key::addReflectances(const SpectralTables& tables) {
    add(static_cast<double>(tables.measure())).add(static_cast<double>(tables.reflectances().size()));
    for (const optics::Curve& reflectance : tables.reflectances()) add(reflectance);
    return *this;
}

void TableMemo::beginScene() {
    std::erase_if(entries_, [](const Entry& entry) { return !entry.isWanted; });
    for (Entry& entry : entries_) entry.isWanted = false;
}

}  // namespace fringe::compile
