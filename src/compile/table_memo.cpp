#include "compile/table_memo.hpp"

namespace fringe::compile {

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
