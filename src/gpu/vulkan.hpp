// Vulkan itself, for what calls it. Its headers take a compiler four seconds, so headers that the rest of the
// program needs (gpu/device.hpp, render/renderer.hpp) do without.
#pragma once

#define VK_NO_PROTOTYPES  // the loader is opened at run time, so that a machine without one gets a message
#include <optional>
#include <string>
#include <vulkan/vulkan_raii.hpp>

#include "gpu/device.hpp"

namespace fringe::gpu {

// Runs `work` and turns what Vulkan throws into a DeviceError; `doing` completes "... while <doing>".
template <class Work>
auto guarded(const std::string& doing, Work&& work) {
    try {
        return work();
    } catch (const vk::OutOfDeviceMemoryError&) {
        throw DeviceError(
            "the device is out of memory while " + doing +
            "; render a smaller picture, or choose another device with --device (see: fringe devices)");
    } catch (const vk::OutOfHostMemoryError&) {
        throw DeviceError("this machine is out of memory while " + doing + "; render a smaller picture");
    } catch (const vk::DeviceLostError&) {
        throw DeviceLost(
            "the device was lost while " + doing +
            " (driver crash, reset or unplugged); run again, or choose another device with --device");
    } catch (const vk::SurfaceLostKHRError&) {
        throw DeviceLost("the desktop took the surface away while " + doing);
    } catch (const vk::Error& error) {
        throw DeviceError(std::string("Vulkan failed while ") + doing + ": " + error.what());
    }
}

// Index of the first memory type allowed by `typeBits` that has all the properties.
std::optional<std::uint32_t> memoryType(const Device& device, std::uint32_t typeBits,
                                        vk::MemoryPropertyFlags properties);

}  // namespace fringe::gpu
