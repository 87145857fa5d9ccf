// What slits make of continuous spectra, one table after the other, as the device has them.
#pragma once

#include <memory>
#include <vector>

#include "compile/interface.hpp"

namespace fringe::compile {

// The tables are shared with the memo that keeps them (table_memo.hpp): a scene that changes by a knob copies
// none.
class ResponseTables {
public:
    using Table = std::shared_ptr<const std::vector<device::ResponseEntry>>;
    struct Part {
        std::size_t first;  // entry of all
        Table table;

        bool operator==(const Part&) const = default;  // the very same table in the same place
    };

    // Returns where it begins.
    std::size_t append(Table table) {
        const std::size_t first = size_;
        size_ += table->size();
        parts_.push_back({first, std::move(table)});
        return first;
    }

    const std::vector<Part>& parts() const { return parts_; }
    std::size_t size() const { return size_; }  // in entries

private:
    std::vector<Part> parts_;
    std::size_t size_ = 0;
};

// All of them in one.
inline std::vector<device::ResponseEntry> entriesOf(const ResponseTables& tables) {
    std::vector<device::ResponseEntry> entries;
    for (const ResponseTables::Part& part : tables.parts())
        entries.insert(entries.end(), part.table->begin(), part.table->end());
    return entries;
}

}  // namespace fringe::compile
