// What a shader module asks of the program that runs it: whether a module from elsewhere may take the place
// of one that was built with the program.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace fringe::gpu {

struct ShaderInterface {
    struct Binding {
        std::string layout;  // kind, type, offsets and strides; the same text for the same bytes
        std::string name;    // empty in a module without names
    };
    using Place = std::pair<std::uint32_t, std::uint32_t>;  // set and binding

    std::map<Place, Binding> bindings;
    std::map<std::uint32_t, std::string> constants;  // of specialisation: by number, with their names
    std::set<std::uint32_t> capabilities;            // that the device is asked for
    std::string workgroup;                           // its size, "8 x 8 x 1"
    bool hasPushConstants = false;
};

// Precondition: a valid module for compute.
ShaderInterface interfaceOf(std::span<const std::uint32_t> spirv);

// Why a module with the interface `wanted` cannot run where the program offers `offered`, whose constants
// have names; empty: it can.
std::string misfit(const ShaderInterface& wanted, const ShaderInterface& offered);

}  // namespace fringe::gpu
