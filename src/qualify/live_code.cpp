#include "qualify/live_code.hpp"

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "gpu/spirv.hpp"

namespace fringe::qualify {
namespace {

using namespace gpu::spirv;

struct Block {
    std::size_t words = 0;
    std::vector<Id> calls;
    std::vector<Id> successors;
};

class Code {
public:
    explicit Code(Words module) {
        forEachInstruction(module, [this](Words words) { read(words); });
    }

    // Of everything that can be reached from the entry point.
    std::size_t liveWords() {
        visitFunction(entry_);
        while (!waiting_.empty()) {
            const Id label = waiting_.back();
            waiting_.pop_back();
            const Block& block = blocks_.at(label);
            live_ += block.words;
            for (const Id function : block.calls) visitFunction(function);
            for (const Id next : block.successors) visitBlock(next);
        }
        return live_;
    }

private:
    void read(Words words) {
        const std::uint32_t opcode = opcodeOf(words);
        switch (opcode) {
            case kEntryPoint:
                entry_ = words[2];
                break;
            case kConstant:
                if (words.size() == 4) constants_[words[2]] = words[3];
                break;
            case kConstantTrue:
            case kConstantFalse:
                constants_[words[2]] = opcode == kConstantTrue ? 1 : 0;
                break;
            case kFunction:
                function_ = words[2];
                break;
            case kFunctionEnd:
                block_ = nullptr;
                break;
            case kLabel:
                block_ = &blocks_[words[1]];
                if (function_ != 0) firstBlocks_[std::exchange(function_, 0)] = words[1];
                break;
            default:
                break;
        }
        if (block_ != nullptr) readInBlock(opcode, words);
    }

    void readInBlock(std::uint32_t opcode, Words words) {
        block_->words += words.size();
        switch (opcode) {
            case kFunctionCall:
                block_->calls.push_back(words[3]);
                break;
            case kULessThan:
                if (constant(words[4]) == 0U) constants_[words[2]] = 0;
                break;
            case kBranch:
                block_->successors.push_back(words[1]);
                break;
            case kBranchConditional: {
                const auto condition = constant(words[1]);
                if (condition != 0U) block_->successors.push_back(words[2]);
                if (condition.value_or(0U) == 0U) block_->successors.push_back(words[3]);
                break;
            }
            case kSwitch:
                block_->successors.push_back(words[2]);
                for (std::size_t i = 4; i < words.size(); i += 2) block_->successors.push_back(words[i]);
                break;
            default:
                break;
        }
    }

    std::optional<std::uint32_t> constant(Id id) const {
        const auto found = constants_.find(id);
        return found == constants_.end() ? std::nullopt : std::optional(found->second);
    }

    void visitFunction(Id function) { visitBlock(firstBlocks_.at(function)); }

    void visitBlock(Id label) {
        if (seen_.insert(label).second) waiting_.push_back(label);
    }

    std::map<Id, std::uint32_t> constants_;
    std::map<Id, Id> firstBlocks_;  // of functions
    std::map<Id, Block> blocks_;
    Id entry_ = 0;
    Id function_ = 0;         // whose first block is yet to come
    Block* block_ = nullptr;  // the one that is read
    std::set<Id> seen_;
    std::vector<Id> waiting_;
    std::size_t live_ = 0;
};

}  // namespace

std::size_t liveCodeBytes(std::span<const std::uint32_t> spirv) {
    return Code(spirv).liveWords() * sizeof(std::uint32_t);
}

}  // namespace fringe::qualify
