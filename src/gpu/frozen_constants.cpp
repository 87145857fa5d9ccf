#include "gpu/frozen_constants.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>

#include "gpu/folding.hpp"
#include "gpu/spirv.hpp"

namespace fringe::gpu {
namespace {

using namespace spirv;

class Freezer {
public:
    Freezer(Words module, std::span<const std::uint32_t> values)
        : given_(values), result_(module.begin(), module.begin() + kHeaderWords) {
        forEachInstruction(module, [this](Words words) { rewrite(words); });
    }

    std::vector<std::uint32_t> take() { return std::move(result_); }

private:
    void rewrite(Words words) {
        switch (opcodeOf(words)) {
            case kDecorate:  // decorations come before what they decorate
                if (words[2] == kSpecId) numbers_[words[1]] = words[3];
                else append(result_, words);
                break;
            case kTypeBool:
                boolType_ = words[1];
                append(result_, words);
                break;
            case kConstant:
                if (words.size() == 4) known_[words[2]] = words[3];
                append(result_, words);
                break;
            case kConstantTrue:
            case kConstantFalse:
                known_[words[2]] = opcodeOf(words) == kConstantTrue ? 1 : 0;
                append(result_, words);
                break;
            case kSpecConstant:
                assert(words.size() == 4);  // 32 bits
                declare(words, given(words[2]).value_or(words[3]));
                break;
            case kSpecConstantTrue:
            case kSpecConstantFalse:
                declare(words, given(words[2]).value_or(opcodeOf(words) == kSpecConstantTrue ? 1 : 0));
                break;
            case kSpecConstantOp:
                if (const auto value = computed(words)) declare(words, *value);
                else append(result_, words);
                break;
            default:
                append(result_, words);
                break;
        }
    }

    std::optional<std::uint32_t> given(Id constant) const {
        const auto number = numbers_.find(constant);
        if (number == numbers_.end() || number->second >= given_.size()) return std::nullopt;
        return given_[number->second];
    }

    std::optional<std::uint32_t> computed(Words words) const {
        std::vector<std::uint32_t> operands;
        for (const Id id : words.subspan(4)) {
            const auto value = known_.find(id);
            if (value == known_.end()) return std::nullopt;
            operands.push_back(value->second);
        }
        return folded(static_cast<Opcode>(words[3]), operands);
    }

    // An ordinary constant of the same type and id as `words`.
    void declare(Words words, std::uint32_t value) {
        known_[words[2]] = value;
        if (words[1] == boolType_) {
            append(result_, value != 0 ? kConstantTrue : kConstantFalse, words.subspan(1, 2));
        } else {
            append(result_, kConstant, std::array{words[1], words[2], value});
        }
    }

    std::span<const std::uint32_t> given_;
    std::map<Id, std::uint32_t> numbers_;  // SpecId of each specialisation constant
    std::map<Id, std::uint32_t> known_;    // values of constants
    Id boolType_ = 0;
    std::vector<std::uint32_t> result_;
};

}  // namespace

std::vector<std::uint32_t> withFrozenConstants(std::span<const std::uint32_t> spirv,
                                               std::span<const std::uint32_t> values) {
    return Freezer(spirv, values).take();
}

}  // namespace fringe::gpu
