// A module is five words of header and then instructions, each with its length and opcode in its first word.
// What has to change is: the variable, the types of the pointers into it, and the types of what is loaded
// through them. Those types are copied, because Private variables must not have Offset and ArrayStride, and
// the same structs may also lie in storage buffers, which must.
#include "gpu/constant_block.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace fringe::gpu {
namespace {

using Words = std::span<const std::uint32_t>;
using Id = std::uint32_t;

// SPIR-V specification 1.5, section 3.
enum Opcode : std::uint32_t {
    kTypeInt = 21,
    kTypeFloat = 22,
    kTypeVector = 23,
    kTypeArray = 28,
    kTypeStruct = 30,
    kTypePointer = 32,
    kConstant = 43,
    kConstantComposite = 44,
    kConstantNull = 46,
    kVariable = 59,
    kLoad = 61,
    kAccessChain = 65,
    kInBoundsAccessChain = 66,
    kDecorate = 71,
    kMemberDecorate = 72,
};
constexpr std::uint32_t kUniform = 2;  // storage classes
constexpr std::uint32_t kPrivate = 6;
constexpr std::uint32_t kArrayStride = 6;  // decorations
constexpr std::uint32_t kOffset = 35;
constexpr std::size_t kHeaderWords = 5;
constexpr std::size_t kBoundWord = 3;  // one more than the largest id
constexpr std::size_t kWordBytes = sizeof(std::uint32_t);

std::uint32_t opcodeOf(Words instruction) {
    return instruction[0] & 0xffffU;
}

// Calls `visit` with each instruction, its first word included.
template <class Visit>
void forEachInstruction(Words module, Visit visit) {
    for (std::size_t at = kHeaderWords; at < module.size();) {
        const std::size_t length = module[at] >> 16;
        assert(length > 0 && at + length <= module.size());
        visit(module.subspan(at, length));
        at += length;
    }
}

// What the module says about its types, before anything is changed.
struct Declarations {
    explicit Declarations(Words module) {
        forEachInstruction(module, [this](Words words) { note(words); });
        assert(variable != 0);
    }

    void note(Words words) {
        switch (opcodeOf(words)) {
            case kTypeInt:
            case kTypeFloat:
            case kTypeVector:
            case kTypeArray:
            case kTypeStruct:
                types[words[1]] = words;
                break;
            case kConstant:
                constants[words[2]] = words[3];
                constantTypes[words[2]] = words[1];
                break;
            case kTypePointer:
                pointees[words[1]] = words[3];
                break;
            case kVariable:
                if (words[3] != kUniform) break;
                assert(variable == 0);  // one block at most
                variable = words[2];
                variableType = words[1];
                break;
            case kDecorate:
                if (words[2] == kArrayStride) strides[words[1]] = words[3];
                break;
            case kMemberDecorate:
                if (words[3] == kOffset) offsets[{words[1], words[2]}] = words[4];
                break;
            default:
                break;
        }
    }

    std::map<Id, Words> types;
    std::map<Id, Id> pointees;
    std::map<Id, std::uint32_t> constants;
    std::map<Id, Id> constantTypes;
    std::map<Id, std::uint32_t> strides;
    std::map<std::pair<Id, std::uint32_t>, std::uint32_t> offsets;  // of member i of a struct
    Id variable = 0;
    Id variableType = 0;
};

class Rewriter {
public:
    Rewriter(Words module, std::span<const std::byte> block)
        : module_(module),
          block_(block),
          declared_(module),
          blockPointers_{declared_.variable},
          result_(module.begin(), module.begin() + kHeaderWords) {
        noteUsedLengths(declared_.pointees.at(declared_.variableType), 0);
    }

    std::vector<std::uint32_t> run() {
        forEachInstruction(module_, [this](Words words) { rewrite(words); });
        return std::move(result_);
    }

private:
    void rewrite(Words words) {
        switch (opcodeOf(words)) {
            case kDecorate:  // binding and set
                if (words[1] != declared_.variable) copy(words);
                break;
            case kTypePointer:
                if (words[2] == kUniform) emit(kTypePointer, {words[1], kPrivate, plainType(words[3])});
                else copy(words);
                break;
            case kVariable:
                if (words[2] == declared_.variable) rewriteVariable(words);
                else copy(words);
                break;
            case kAccessChain:
            case kInBoundsAccessChain:
                if (blockPointers_.contains(words[3])) blockPointers_.insert(words[2]);
                copy(words);
                break;
            case kLoad:
                copy(words);
                if (blockPointers_.contains(words[3]))
                    result_[result_.size() - words.size() + 1] = plainType(words[1]);
                break;
            default:
                copy(words);
                break;
        }
    }

    void rewriteVariable(Words words) {
        const Id block = declared_.pointees.at(words[1]);
        assert(sizeOf(block) <= block_.size());
        const Id initial = constant(block, 0);
        emit(kVariable, {words[1], words[2], kPrivate, initial});
    }

    void copy(Words words) { result_.insert(result_.end(), words.begin(), words.end()); }

    void emit(Opcode opcode, const std::vector<std::uint32_t>& operands) {
        result_.push_back(static_cast<std::uint32_t>(operands.size() + 1) << 16 | opcode);
        result_.insert(result_.end(), operands.begin(), operands.end());
    }

    Id newId() { return result_[kBoundWord]++; }

    // ---- types ----------------------------------------------------------------------------------

    // The same type without a layout; emitted where it is first asked for, which is before its first use.
    Id plainType(Id type) {
        if (const auto known = plainTypes_.find(type); known != plainTypes_.end()) return known->second;
        const Words words = declared_.types.at(type);
        std::vector<std::uint32_t> operands(words.begin() + 1, words.end());
        if (opcodeOf(words) == kTypeStruct) {
            for (std::size_t i = 1; i < operands.size(); ++i) operands[i] = plainType(operands[i]);
        } else if (opcodeOf(words) == kTypeArray) {
            operands[1] = plainType(operands[1]);
            operands[2] =
                declare(kConstant, declared_.constantTypes.at(operands[2]), {usedLengths_.at(type)});
        } else {
            return type;  // numbers and vectors have no layout, and may not be declared twice
        }
        operands[0] = newId();
        emit(static_cast<Opcode>(opcodeOf(words)), operands);
        plainTypes_.emplace(type, operands[0]);
        return operands[0];
    }

    struct Part {
        Id type;
        std::size_t offset;  // in bytes, from the start of the whole
    };

    std::vector<Part> partsOf(Id type) const {
        const Words words = declared_.types.at(type);
        std::vector<Part> parts;
        switch (opcodeOf(words)) {
            case kTypeVector:
                for (std::size_t i = 0; i < words[3]; ++i) parts.push_back({words[2], i * kWordBytes});
                break;
            case kTypeArray:
                for (std::size_t i = 0; i < declared_.constants.at(words[3]); ++i) {
                    parts.push_back({words[2], i * declared_.strides.at(type)});
                }
                break;
            case kTypeStruct:
                for (std::uint32_t i = 0; i + 2 < words.size(); ++i) {
                    parts.push_back({words[i + 2], declared_.offsets.at({type, i})});
                }
                break;
            default:
                assert(words[2] == 32);  // bits of a number
                break;
        }
        return parts;
    }

    // Unused elements would be initialised one by one: they double the time to compile.
    void noteUsedLengths(Id type, std::size_t offset) {
        const std::vector<Part> parts = partsOf(type);
        const bool isArray = !parts.empty() && opcodeOf(declared_.types.at(type)) == kTypeArray;
        std::uint32_t used = 1;
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            noteUsedLengths(parts[i].type, offset + parts[i].offset);
            if (isArray && !isZero(parts[i].type, offset + parts[i].offset)) used = i + 1;
        }
        if (isArray) usedLengths_[type] = std::max(usedLengths_[type], used);
    }

    bool isZero(Id type, std::size_t offset) const {
        const auto bytes = block_.subspan(offset, sizeOf(type));
        return std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
    }

    // Bytes from its start to the end of its last part.
    std::size_t sizeOf(Id type) const {
        const std::vector<Part> parts = partsOf(type);
        return parts.empty() ? kWordBytes : parts.back().offset + sizeOf(parts.back().type);
    }

    // ---- constants ------------------------------------------------------------------------------

    // What the block holds at `offset`, as a constant of the plain type. Equal ones are declared once.
    Id constant(Id type, std::size_t offset) {
        const std::vector<Part> parts = partsOf(type);
        if (parts.empty()) {
            std::uint32_t word = 0;
            std::memcpy(&word, block_.data() + offset, kWordBytes);
            return declare(kConstant, type, {word});
        }
        if (isZero(type, offset)) {
            return declare(kConstantNull, plainType(type), {});
        }
        std::vector<Id> constituents;
        const std::size_t used =
            opcodeOf(declared_.types.at(type)) == kTypeArray ? usedLengths_.at(type) : parts.size();
        for (const Part& part : std::span(parts).first(used))
            constituents.push_back(constant(part.type, offset + part.offset));
        return declare(kConstantComposite, plainType(type), constituents);
    }

    Id declare(Opcode opcode, Id type, const std::vector<std::uint32_t>& operands) {
        const auto [known, isNew] = constants_.try_emplace({opcode, type, operands}, 0);
        if (isNew) {
            known->second = newId();
            std::vector<std::uint32_t> words{type, known->second};
            words.insert(words.end(), operands.begin(), operands.end());
            emit(opcode, words);
        }
        return known->second;
    }

    Words module_;
    std::span<const std::byte> block_;
    Declarations declared_;
    std::set<Id> blockPointers_;  // the variable, and pointers to parts of it
    std::map<Id, Id> plainTypes_;
    std::map<Id, std::uint32_t> usedLengths_;
    std::map<std::tuple<Opcode, Id, std::vector<std::uint32_t>>, Id> constants_;
    std::vector<std::uint32_t> result_;
};

}  // namespace

std::vector<std::uint32_t> withConstantBlock(std::span<const std::uint32_t> spirv,
                                             std::span<const std::byte> block) {
    return Rewriter(spirv, block).run();
}

}  // namespace fringe::gpu
