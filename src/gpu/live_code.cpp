// Control flow stays structured as the specification asks for (section 2.11): what a loop goes on with, and
// where it and a selection end, has to exist even if nothing gets there, and is then left as an empty block.
#include "gpu/live_code.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "gpu/folding.hpp"
#include "gpu/spirv.hpp"

namespace fringe::gpu {
namespace {

using namespace spirv;

// The id that an instruction in a function defines; 0 for none.
Id resultOf(Words words) {
    switch (opcodeOf(words)) {
        case kLabel:
            return words[1];
        case kFunctionEnd:
        case kStore:
        case kCopyMemory:
        case kCopyMemorySized:
        case kImageWrite:
        case kControlBarrier:
        case kMemoryBarrier:
        case kAtomicStore:
        case kLoopMerge:
        case kSelectionMerge:
        case kBranch:
        case kBranchConditional:
        case kSwitch:
        case kKill:
        case kReturn:
        case kReturnValue:
        case kUnreachable:
            return 0;
        default:
            return words.size() > 2 ? words[2] : 0;
    }
}

struct Block {
    std::vector<Words> instructions;  // the label first, the branch last
    bool isLive = false;
    std::vector<Id> successors;  // where its branch may go, once it is live

    Id label() const { return instructions.front()[1]; }
    Words branch() const { return instructions.back(); }

    // Its OpLoopMerge or OpSelectionMerge.
    std::optional<Words> merge() const {
        if (instructions.size() < 3) return {};
        const Words words = instructions[instructions.size() - 2];
        const Opcode opcode = opcodeOf(words);
        if (opcode != kLoopMerge && opcode != kSelectionMerge) return {};
        return words;
    }
    bool isLoop() const { return merge() && opcodeOf(*merge()) == kLoopMerge; }
};

std::vector<Id> targetsOf(Words branch) {
    switch (opcodeOf(branch)) {
        case kBranch:
            return {branch[1]};
        case kBranchConditional:
            return {branch[2], branch[3]};
        case kSwitch: {
            std::vector<Id> targets;
            for (std::size_t i = 2; i < branch.size(); i += 2) targets.push_back(branch[i]);
            return targets;
        }
        default:
            return {};
    }
}

class LiveCode {
public:
    explicit LiveCode(Words module)
        : result_(module.begin(), module.begin() + kHeaderWords),
          nextId_(module[kBoundWord]),
          known_(nextId_),
          blockOf_(nextId_),
          isDefined_(nextId_, true),
          callees_(nextId_) {
        std::vector<Words> globals;
        bool inFunctions = false;
        forEachInstruction(module, [&](Words words) {
            inFunctions = inFunctions || opcodeOf(words) == kFunction;
            if (!inFunctions) {
                noteGlobal(words);
                globals.push_back(words);
                return;
            }
            if (opcodeOf(words) == kFunction) functions_.emplace_back();
            functions_.back().instructions.push_back(words);
        });
        for (Function& function : functions_) prune(function);
        dropUncalled();
        for (const Words words : globals) {
            const Opcode opcode = opcodeOf(words);
            if ((opcode == kDecorate || opcode == kName) && !isDefined_[words[1]]) continue;
            append(result_, words);
        }
        for (const Function& function : functions_) append(result_, function.live);
        result_[kBoundWord] = nextId_;
    }

    std::vector<std::uint32_t> take() { return std::move(result_); }

private:
    struct Function {
        std::vector<Words> instructions;
        std::vector<std::uint32_t> live;

        Id id() const { return instructions.front()[2]; }
    };
    using Known = std::optional<std::uint32_t>;

    void noteGlobal(Words words) {
        const Opcode opcode = opcodeOf(words);
        if (opcode == kEntryPoint) entries_.push_back(words[2]);
        if (opcode == kConstant && words.size() == 4) known_[words[2]] = words[3];
        if (opcode == kConstantTrue || opcode == kConstantFalse)
            known_[words[2]] = opcode == kConstantTrue ? 1 : 0;
    }

    void prune(Function& function) {
        blocks_.clear();
        std::size_t before = 0;  // OpFunction and parameters
        for (const Words words : function.instructions) {
            if (opcodeOf(words) == kLabel) {
                blockOf_[words[1]] = blocks_.size();
                blocks_.emplace_back();
            }
            if (blocks_.empty()) ++before;
            else if (opcodeOf(words) != kFunctionEnd) blocks_.back().instructions.push_back(words);
        }
        const bool inOrder = isInOrder();
        if (!blocks_.empty()) blocks_.front().isLive = true;
        for (Block& block : blocks_) {
            if (!inOrder) block.isLive = true;
            if (block.isLive) follow(block, inOrder);
        }
        for (const Words words : std::span(function.instructions).first(before)) append(function.live, words);
        for (const Block& block : blocks_) emit(block, function);
        append(function.live, kFunctionEnd, {});
    }

    // No branch goes back but to the head of a loop.
    bool isInOrder() const {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            for (const Id target : targetsOf(blocks_[i].branch())) {
                if (blockOf_[target] <= i && !blocks_[blockOf_[target]].isLoop()) return false;
            }
        }
        return true;
    }

    // Computes what is known in a live block and marks where it goes on.
    void follow(Block& block, bool folds) {
        if (folds) {
            for (const Words words : block.instructions)
                if (const Id id = resultOf(words); id != 0 && opcodeOf(words) != kLabel)
                    known_[id] = opcodeOf(words) == kPhi ? ofPhi(words, block) : ofOperation(words);
        }
        block.successors = targetsOf(block.branch());
        if (folds && opcodeOf(block.branch()) == kBranchConditional) {
            const auto isBack = [&](Id target) { return blockOf_[target] <= blockOf_[block.label()]; };
            const Known condition = known_[block.branch()[1]];
            if (condition && !std::any_of(block.successors.begin(), block.successors.end(), isBack))
                block.successors = {block.successors[*condition != 0 ? 0 : 1]};
        }
        for (const Id target : block.successors) blocks_[blockOf_[target]].isLive = true;
    }

    Known ofOperation(Words words) const {
        std::array<std::uint32_t, 3> operands{};
        const std::size_t count = words.size() - 3;
        if (words.size() < 4 || count > operands.size()) return {};
        const Opcode opcode = opcodeOf(words);
        const auto is = [&](std::size_t i, std::uint32_t value) { return known_[words[i]] == value; };
        // What one operand alone decides; `i < 0` is never true and makes loops of no turns.
        if (opcode == kULessThan && is(4, 0)) return 0;
        if (opcode == kLogicalAnd && (is(3, 0) || is(4, 0))) return 0;
        if (opcode == kLogicalOr && (is(3, 1) || is(4, 1))) return 1;
        if (opcode < kIAdd || opcode > kShiftLeftLogical) return {};  // its operands need not be ids
        for (std::size_t i = 0; i < count; ++i) {
            if (!known_[words[i + 3]]) return {};
            operands[i] = *known_[words[i + 3]];
        }
        return folded(opcode, std::span(operands).first(count));
    }

    bool goesTo(Id from, Id to) const {
        const Block& block = blocks_[blockOf_[from]];
        return block.isLive &&
               std::find(block.successors.begin(), block.successors.end(), to) != block.successors.end();
    }

    // The value, if it is the same by all ways that are left.
    Known ofPhi(Words words, const Block& block) const {
        Known value;
        for (std::size_t i = 3; i + 1 < words.size(); i += 2) {
            const bool isLater = blockOf_[words[i + 1]] >= blockOf_[block.label()];
            if (!isLater && !goesTo(words[i + 1], block.label())) continue;
            const Known one = known_[words[i]];
            if (isLater || !one || (value && *value != *one)) return {};
            value = one;
        }
        return value;
    }

    void emit(const Block& block, Function& function) {
        if (!block.isLive) {
            for (const Words words : block.instructions)
                if (const Id id = resultOf(words); id != 0) isDefined_[id] = false;
            emitEmpty(block, function.live);
            return;
        }
        const bool isFolded = block.successors.size() < targetsOf(block.branch()).size();
        for (const Words words : block.instructions) {
            const Opcode opcode = opcodeOf(words);
            if (opcode == kPhi) emitPhi(words, block, function.live);
            else if (isFolded && opcode == kSelectionMerge) continue;
            else if (isFolded && opcode == kBranchConditional)
                append(function.live, kBranch, std::array{block.successors[0]});
            else append(function.live, words);
            if (opcode == kFunctionCall) callees_[function.id()].push_back(words[3]);
        }
    }

    // Where a live block's loop goes on, or where it or a selection ends.
    void emitEmpty(const Block& block, std::vector<std::uint32_t>& live) {
        for (const Block& head : blocks_) {
            const auto merge = head.merge();
            if (!head.isLive || !merge) continue;
            const bool isFolded = head.successors.size() < targetsOf(head.branch()).size();
            const bool isContinue = head.isLoop() && (*merge)[2] == block.label();
            const bool isEnd = (*merge)[1] == block.label() && (head.isLoop() || !isFolded);
            if (!isContinue && !isEnd) continue;
            isDefined_[block.label()] = true;
            append(live, kLabel, std::array{block.label()});
            if (isContinue) {
                for (const auto& [type, id] : undefined_[block.label()])
                    append(live, kUndef, std::array{type, id});
                append(live, kBranch, std::array{head.label()});
            } else {
                append(live, kUnreachable, {});
            }
            return;
        }
    }

    void emitPhi(Words words, const Block& block, std::vector<std::uint32_t>& live) {
        std::vector<std::uint32_t> operands(words.begin() + 1, words.begin() + 3);
        for (std::size_t i = 3; i + 1 < words.size(); i += 2) {
            if (goesTo(words[i + 1], block.label())) append(operands, words.subspan(i, 2));
        }
        if (block.isLoop()) {
            const Id goesOn = (*block.merge())[2];
            if (!blocks_[blockOf_[goesOn]].isLive) {
                const Id id = nextId_++;
                undefined_[goesOn].emplace_back(words[1], id);
                append(operands, std::array{id, goesOn});
            }
        }
        append(live, kPhi, operands);
    }

    void dropUncalled() {
        std::vector<Id> called = entries_;
        for (std::size_t i = 0; i < called.size(); ++i) {
            for (const Id callee : callees_[called[i]]) {
                if (std::find(called.begin(), called.end(), callee) == called.end()) called.push_back(callee);
            }
        }
        std::erase_if(functions_, [&](const Function& function) {
            if (std::find(called.begin(), called.end(), function.id()) != called.end()) return false;
            for (const Words words : function.instructions)
                if (const Id id = resultOf(words); id != 0) isDefined_[id] = false;
            return true;
        });
    }

    std::vector<std::uint32_t> result_;
    Id nextId_;
    std::vector<Known> known_;              // of ids
    std::vector<std::size_t> blockOf_;      // of labels, in their function
    std::vector<bool> isDefined_;           // ids that are left
    std::vector<std::vector<Id>> callees_;  // of functions
    std::vector<Id> entries_;
    std::vector<Function> functions_;
    std::vector<Block> blocks_;  // of the function at hand
    std::map<Id, std::vector<std::pair<Id, Id>>>
        undefined_;  // type and id, of what empty blocks have to define
};

}  // namespace

std::vector<std::uint32_t> withoutDeadCode(std::span<const std::uint32_t> spirv) {
    return LiveCode(spirv).take();
}

}  // namespace fringe::gpu
