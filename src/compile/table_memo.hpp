// Tables of gratings, kept from one scene to the next: of a scene that changes by a knob most stay as they
// are. A table is known by the numbers that it depends on, all of them.
#pragma once

#include <algorithm>
#include <any>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "compile/spectral.hpp"
#include "optics/aperture.hpp"

namespace fringe::compile {

class TableMemo {
public:
    // Of a table. Sequences are written with their length, so that equal numbers mean equal tables.
    class Key {
    public:
        Key& add(double value);
        Key& add(const optics::Curve& curve);
        Key& add(const optics::Spectrum& spectrum);
        Key& add(std::span<const float> values);
        Key& add(const optics::Aperture& aperture);
        Key& addReflectances(const SpectralTables& tables);  // and what is measured
        void addDraft() { isDraft_ = true; }

        bool isDraft() const { return isDraft_; }
        bool operator==(const Key&) const = default;

    private:
        std::vector<double> numbers_;
        bool isDraft_ = false;
    };

    // A scene is compiled from here on: what the one before it did not ask for is let go.
    void beginScene();

    // From now on new tables may be drafts (rememberedOrDraft()), for a scene that is about to change again.
    void wantDrafts(bool wanted) { wantsDrafts_ = wanted; }
    bool wantsDrafts() const { return wantsDrafts_; }

    // Whether the scene that was compiled last has any.
    bool hasDrafts() const {
        return std::any_of(entries_.begin(), entries_.end(),
                           [](const Entry& entry) { return entry.isWanted && entry.key.isDraft(); });
    }

    bool has(const Key& key) const {
        return std::any_of(entries_.begin(), entries_.end(),
                           [&](const Entry& entry) { return entry.key == key; });
    }

    // What `make` returned for an equal key, or returns now. Precondition: a key stands for one type.
    template <class Make>
    auto table(Key key, Make make) {
        using Table = std::invoke_result_t<Make>;
        const auto known = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& entry) { return entry.key == key; });
        if (known != entries_.end()) {
            known->isWanted = true;
            return std::any_cast<std::shared_ptr<const Table>>(known->table);
        }
        auto made = std::make_shared<const Table>(make());
        entries_.push_back({std::move(key), made, true});
        return made;
    }

private:
    struct Entry {
        Key key;
        std::any table;
        bool isWanted;  // by the scene that is being compiled
    };

    std::vector<Entry> entries_;
    bool wantsDrafts_ = false;
};

// TableMemo::table(), or what `make` returns where there is no memo.
template <class Make>
auto rememberedTable(TableMemo* memo, TableMemo::Key key, Make make) {
    using Table = std::invoke_result_t<Make>;
    return memo == nullptr ? std::make_shared<const Table>(make()) : memo->table(std::move(key), make);
}

// The same of a table that a draft will do for, where drafts are wanted and the table is not there yet;
// `make` is told whether it is to be one.
template <class Make>
auto rememberedOrDraft(TableMemo* memo, TableMemo::Key key, Make make) {
    const bool isDraft = memo != nullptr && memo->wantsDrafts() && !memo->has(key);
    if (isDraft) key.addDraft();
    return rememberedTable(memo, std::move(key), [&] { return make(isDraft); });
}

}  // namespace fringe::compile
