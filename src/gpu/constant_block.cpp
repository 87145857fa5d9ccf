// Values take the place of loads, instead of a Private variable with an initialiser taking the place of the
// block, because drivers turn an initialiser into a store per member at the start of the shader: with some
// 2000 numbers lavapipe then spends longer on those than it saves.
#include "gpu/constant_block.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "gpu/spirv.hpp"

namespace fringe::gpu {
namespace {

using namespace spirv;

constexpr std::size_t kWordBytes = sizeof(std::uint32_t);

// What the module says about its types, its numbers and its uniform block.
class Declarations {
public:
    explicit Declarations(Words module) {
        assert(module[kVersionWord] >= 0x00010400);
        forEachInstruction(module, [this](Words words) { note(words); });
        assert(blockType != 0 && boolType != 0 && uintType != 0);
    }

    struct Part {
        Id type;
        std::size_t offset;  // in bytes, from the start of the whole
    };

    // Members, elements or components of a type; none of a number.
    std::vector<Part> partsOf(Id type) const {
        const Words words = types_.at(type);
        std::vector<Part> parts;
        switch (opcodeOf(words)) {
            case kTypeVector:
                for (std::size_t i = 0; i < words[3]; ++i) parts.push_back({words[2], i * kWordBytes});
                break;
            case kTypeArray:
                for (std::size_t i = 0; i < numbers.at(words[3]); ++i) {
                    parts.push_back({words[2], i * strides_.at(type)});
                }
                break;
            case kTypeStruct:
                for (std::uint32_t i = 0; i + 2 < words.size(); ++i) {
                    parts.push_back({words[i + 2], offsets_.at({type, i})});
                }
                break;
            default:
                assert(words[2] == 32);  // bits of a number
                break;
        }
        return parts;
    }

    // Bytes from the start of a value to the end of its last part.
    std::size_t sizeOf(Id type) const {
        const std::vector<Part> parts = partsOf(type);
        return parts.empty() ? kWordBytes : parts.back().offset + sizeOf(parts.back().type);
    }

    Id boolType = 0;
    Id uintType = 0;
    Id blockType = 0;
    std::map<Id, std::uint32_t> numbers;          // value of each integer constant
    std::map<Id, std::vector<Id>> blockPointers;  // the block's variable and what points into it: the indices

private:
    void note(Words words) {
        switch (opcodeOf(words)) {
            case kTypeBool:
                boolType = words[1];
                break;
            case kTypeInt:
                if (words[2] == 32 && words[3] == 0) uintType = words[1];
                types_[words[1]] = words;
                break;
            case kTypeFloat:
            case kTypeVector:
            case kTypeArray:
            case kTypeStruct:
                types_[words[1]] = words;
                break;
            case kTypePointer:
                pointees_[words[1]] = words[3];
                break;
            case kConstant:
                numbers[words[2]] = words[3];
                break;
            case kVariable:
                if (words[3] == kUniform) noteBlock(words);
                break;
            case kAccessChain:
            case kInBoundsAccessChain:
                noteAccessChain(words);
                break;
            case kDecorate:
                if (words[2] == kArrayStride) strides_[words[1]] = words[3];
                break;
            case kMemberDecorate:
                if (words[3] == kOffset) offsets_[{words[1], words[2]}] = words[4];
                break;
            default:
                break;
        }
    }

    void noteBlock(Words variable) {
        assert(blockType == 0);
        blockType = pointees_.at(variable[1]);
        blockPointers[variable[2]] = {};
    }

    void noteAccessChain(Words chain) {
        const auto base = blockPointers.find(chain[3]);
        if (base == blockPointers.end()) return;
        std::vector<Id> path = base->second;
        append(path, chain.subspan(4));
        blockPointers[chain[2]] = std::move(path);
    }

    std::map<Id, Words> types_;
    std::map<Id, Id> pointees_;
    std::map<Id, std::uint32_t> strides_;
    std::map<std::pair<Id, std::uint32_t>, std::uint32_t> offsets_;  // of member i of a struct
};

class Rewriter {
public:
    Rewriter(Words module, std::span<const std::byte> block)
        : module_(module), block_(block), declared_(module), bound_(module[kBoundWord]) {
        assert(declared_.sizeOf(declared_.blockType) <= block.size());
    }

    std::vector<std::uint32_t> run() {
        std::vector<std::uint32_t> result(module_.begin(), module_.begin() + kHeaderWords);
        std::vector<std::uint32_t> functions;  // first, for the constants that stand before them
        forEachInstruction(module_, [&](Words words) {
            const bool global = functions.empty() && opcodeOf(words) != kFunction;
            rewrite(words, global ? result : functions);
        });
        append(result, constants_);
        append(result, functions);
        result[kBoundWord] = bound_;
        return result;
    }

private:
    bool pointsIntoBlock(Id id) const { return declared_.blockPointers.contains(id); }

    void rewrite(Words words, std::vector<std::uint32_t>& out) {
        switch (opcodeOf(words)) {
            case kName:
            case kDecorate:
                if (!pointsIntoBlock(words[1])) append(out, words);
                break;
            case kVariable:
            case kAccessChain:
            case kInBoundsAccessChain:
                if (!pointsIntoBlock(words[2])) append(out, words);
                break;
            case kEntryPoint:
                rewriteEntryPoint(words, out);
                break;
            case kLoad:
                if (pointsIntoBlock(words[3])) rewriteLoad(words, out);
                else append(out, words);
                break;
            default:
                append(out, words);
                break;
        }
    }

    // The block is no longer among the variables that the entry point lists. They follow its name, the first
    // word of which with a zero byte is the last.
    void rewriteEntryPoint(Words words, std::vector<std::uint32_t>& out) {
        const auto endsText = [](std::uint32_t word) { return (word >> 24) == 0; };
        const auto interface = std::find_if(words.begin() + 3, words.end(), endsText) + 1;
        std::vector<std::uint32_t> operands(words.begin() + 1, interface);
        std::copy_if(interface, words.end(), std::back_inserter(operands),
                     [this](Id variable) { return !pointsIntoBlock(variable); });
        append(out, kEntryPoint, operands);
    }

    void rewriteLoad(Words words, std::vector<std::uint32_t>& out) {
        const std::vector<Id>& path = declared_.blockPointers.at(words[3]);
        const Id value = valueAt(declared_.blockType, 0, path, out);
        append(out, kCopyObject, std::array{words[1], words[2], value});
    }

    // What the block holds where `path` leads from a value of `type` at `offset`. Selections go to `out`.
    Id valueAt(Id type, std::size_t offset, std::span<const Id> path, std::vector<std::uint32_t>& out) {
        if (path.empty()) return constant(type, offset);
        const std::vector<Declarations::Part> parts = declared_.partsOf(type);
        const auto follow = [&](const Declarations::Part& part) {
            return valueAt(part.type, offset + part.offset, path.subspan(1), out);
        };
        if (const auto index = declared_.numbers.find(path[0]); index != declared_.numbers.end()) {
            return follow(parts.at(index->second));
        }
        std::vector<Id> values;
        std::transform(parts.begin(), parts.end(), std::back_inserter(values), follow);
        return select(path[0], values, typeAt(type, path), out);
    }

    Id typeAt(Id type, std::span<const Id> path) const {
        for (const Id index : path) {
            const auto known = declared_.numbers.find(index);  // all parts are alike if it is not known
            type = declared_.partsOf(type).at(known != declared_.numbers.end() ? known->second : 0).type;
        }
        return type;
    }

    // values[index]. Whatever equals the last needs no selection: mostly these are the zeros of an array's
    // free places.
    Id select(Id index, const std::vector<Id>& values, Id type, std::vector<std::uint32_t>& out) {
        Id result = values.back();
        for (std::uint32_t i = 0; i < values.size(); ++i) {
            if (values[i] == values.back()) continue;
            const Id number = declare(kConstant, declared_.uintType, {i});
            const Id isIt = bound_++;
            append(out, kIEqual, std::array{declared_.boolType, isIt, index, number});
            const Id selected = bound_++;
            append(out, kSelect, std::array{type, selected, isIt, values[i], result});
            result = selected;
        }
        return result;
    }

    Id constant(Id type, std::size_t offset) {
        const std::vector<Declarations::Part> parts = declared_.partsOf(type);
        if (parts.empty()) {
            std::uint32_t word = 0;
            std::memcpy(&word, block_.data() + offset, kWordBytes);
            return declare(kConstant, type, {word});
        }
        const auto bytes = block_.subspan(offset, declared_.sizeOf(type));
        if (std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; })) {
            return declare(kConstantNull, type, {});
        }
        std::vector<Id> constituents;
        for (const auto& part : parts) constituents.push_back(constant(part.type, offset + part.offset));
        return declare(kConstantComposite, type, constituents);
    }

    // Equal constants are declared once, and so have one id.
    Id declare(Opcode opcode, Id type, const std::vector<std::uint32_t>& operands) {
        const auto [known, isNew] = known_.try_emplace({opcode, type, operands}, bound_);
        if (isNew) {
            std::vector<std::uint32_t> words{type, bound_++};
            append(words, operands);
            append(constants_, opcode, words);
        }
        return known->second;
    }

    Words module_;
    std::span<const std::byte> block_;
    Declarations declared_;
    Id bound_;
    std::map<std::tuple<Opcode, Id, std::vector<std::uint32_t>>, Id> known_;
    std::vector<std::uint32_t> constants_;
};

}  // namespace

std::vector<std::uint32_t> withConstantBlock(std::span<const std::uint32_t> spirv,
                                             std::span<const std::byte> block) {
    return Rewriter(spirv, block).run();
}

}  // namespace fringe::gpu
