#include "gpu/shader_interface.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <vector>

#include "gpu/spirv.hpp"

namespace fringe::gpu {
namespace {

using namespace spirv;

// Numbers from an instruction's words on, without the type's own id.
std::string wordsFrom(Words words, std::size_t first) {
    return fmt::format("{}", fmt::join(words.subspan(first), " "));
}

std::string textAt(Words words, std::size_t first) {
    std::string text;
    for (const std::uint32_t word : words.subspan(first)) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            const char letter = static_cast<char>(word >> shift & 0xffU);
            if (letter == '\0') return text;
            text += letter;
        }
    }
    return text;
}

class Reader {
public:
    explicit Reader(Words module) {
        forEachInstruction(module, [this](Words words) { note(words); });
        for (const auto& [variable, storage] : variables_) addVariable(variable, storage);
        for (const auto& [constant, number] : numbers_) result_.constants[number] = names_[constant];
    }

    ShaderInterface take() { return std::move(result_); }

private:
    void note(Words words) {
        switch (opcodeOf(words)) {
            case kCapability:
                result_.capabilities.insert(words[1]);
                break;
            case kExecutionMode:
                if (words[2] == kLocalSize)
                    result_.workgroup = fmt::format("{} x {} x {}", words[3], words[4], words[5]);
                break;
            case kName:
                names_[words[1]] = textAt(words, 2);
                break;
            case kDecorate:
                if (words[2] == kSpecId) numbers_[words[1]] = words[3];
                if (words[2] == kArrayStride) strides_[words[1]] = words[3];
                if (words[2] == kBinding) bindings_[words[1]] = words[3];
                if (words[2] == kDescriptorSet) sets_[words[1]] = words[3];
                break;
            case kMemberDecorate:
                if (words[3] == kOffset) offsets_[{words[1], words[2]}] = words[4];
                break;
            case kConstant:
                constants_[words[2]] = words[3];
                break;
            case kVariable:
                variables_[words[2]] = words[3];
                pointers_[words[2]] = words[1];
                break;
            default:
                if (kFirstType <= opcodeOf(words) && opcodeOf(words) <= kTypePointer)
                    types_[words[1]] = words;
                break;
        }
    }

    void addVariable(Id variable, std::uint32_t storage) {
        if (storage == kPushConstant) result_.hasPushConstants = true;
        if (!bindings_.contains(variable)) return;
        const Id type = types_.at(pointers_.at(variable))[3];
        // A block's own name is that of its type; its variable may have none.
        const std::string& name = names_[variable].empty() ? names_[type] : names_[variable];
        result_.bindings[{sets_[variable], bindings_[variable]}] = {
            fmt::format("{}: {}", storage, layoutOf(type)), name};
    }

    std::string layoutOf(Id type) const {
        const Words words = types_.at(type);
        const auto stride = strides_.find(type);
        const std::string step = stride == strides_.end() ? "" : fmt::format(" every {}", stride->second);
        switch (opcodeOf(words)) {
            case kTypeVector:
                return fmt::format("{} of {}", words[3], layoutOf(words[2]));
            case kTypeArray:
                return fmt::format("[{}]{} of {}",
                                   constants_.contains(words[3]) ? constants_.at(words[3]) : 0, step,
                                   layoutOf(words[2]));
            case kTypeRuntimeArray:
                return fmt::format("[]{} of {}", step, layoutOf(words[2]));
            case kTypeStruct: {
                std::string text = "{";
                for (std::uint32_t i = 0; i + 2 < words.size(); ++i) {
                    const auto offset = offsets_.find({type, i});
                    text += fmt::format(" {}: {};", offset == offsets_.end() ? 0 : offset->second,
                                        layoutOf(words[i + 2]));
                }
                return text + " }";
            }
            case kTypeImage:
                return fmt::format("image {} of {}", wordsFrom(words, 3), layoutOf(words[2]));
            default:  // a number: its width and sign
                return fmt::format("{} {}", words[0] & 0xffffU, wordsFrom(words, 2));
        }
    }

    std::map<Id, std::string> names_;
    std::map<Id, std::uint32_t> numbers_, strides_, bindings_, sets_, constants_, variables_;
    std::map<Id, Id> pointers_;  // types of variables
    std::map<std::pair<Id, std::uint32_t>, std::uint32_t> offsets_;
    std::map<Id, Words> types_;
    ShaderInterface result_;
};

}  // namespace

ShaderInterface interfaceOf(std::span<const std::uint32_t> spirv) {
    return Reader(spirv).take();
}

std::string misfit(const ShaderInterface& wanted, const ShaderInterface& offered) {
    if (wanted.hasPushConstants) return "it has push constants, which the program does not set";
    if (wanted.workgroup != offered.workgroup)
        return fmt::format("its workgroups are {}, those of the program {}", wanted.workgroup,
                           offered.workgroup);
    for (const auto& [place, binding] : wanted.bindings) {
        const auto same = offered.bindings.find(place);
        const std::string what =
            fmt::format("set {}, binding {} ({})", place.first, place.second, binding.name);
        if (same == offered.bindings.end()) return fmt::format("the program has nothing for {}", what);
        if (same->second.layout != binding.layout)
            return fmt::format("{} is laid out otherwise than in the program", what);
    }
    for (const auto& [number, name] : wanted.constants) {
        const auto same = offered.constants.find(number);
        if (same == offered.constants.end())
            return fmt::format("the program has no constant {} ({})", number, name);
        if (!name.empty() && same->second != name)
            return fmt::format("constant {} is {}, but {} in the program", number, name, same->second);
    }
    for (const std::uint32_t capability : wanted.capabilities) {
        if (!offered.capabilities.contains(capability))
            return fmt::format(
                "it needs SPIR-V's capability {}, which the program does not ask the device for", capability);
    }
    return {};
}

}  // namespace fringe::gpu
