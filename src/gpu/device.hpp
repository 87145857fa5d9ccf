// A Vulkan 1.2 device with one compute queue, chosen and ready to work, or a DeviceError that says why not.
// Everything of Vulkan (gpu/vulkan.hpp) stays inside src/gpu, src/preview and what src/render keeps to
// itself; failures of the driver leave them as DeviceError.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace vk {
struct PhysicalDeviceLimits;
namespace raii {
class CommandPool;
class Device;
class Instance;
class PhysicalDevice;
class Queue;
}  // namespace raii
}  // namespace vk

namespace fringe::gpu {

// The machine cannot do it: no driver, no usable device, out of memory, device lost. The message says what to
// do.
class DeviceError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The device is of no more use, or the surface that it draws on; another one may be.
class DeviceLost : public DeviceError {
public:
    using DeviceError::DeviceError;
};

struct DeviceDescription {
    std::string name;
    std::string type;                  // "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;                // name and version, as the driver gives them
    std::string vulkan;                // version
    std::vector<std::string> missing;  // what Fringe needs and the device lacks; empty: it can run Fringe

    bool isProcessor() const { return type == "CPU"; }
};

// All devices of this machine, in the loader's order. Throws DeviceError when there is no Vulkan at all.
std::vector<DeviceDescription> listDevices();

struct DeviceRequest {
    std::string selector;     // part of a name (any case) or an index; empty: the best usable device
    bool validation = false;  // with the Khronos validation layer, synchronisation included
    // Instance extensions that a window's surface needs; the queue then draws as well, and the device has
    // swapchains. None: nothing is shown.
    std::vector<const char*> surfaceExtensions = {};
};

class Device {
public:
    explicit Device(const DeviceRequest& request);
    ~Device();
    Device(Device&&) noexcept;

    const DeviceDescription& description() const;
    const vk::raii::Device& handle() const;
    const vk::raii::Queue& queue() const;
    const vk::raii::CommandPool& commandPool() const;
    const vk::PhysicalDeviceLimits& limits() const;
    const vk::raii::Instance& instance() const;
    const vk::raii::PhysicalDevice& physical() const;
    std::uint32_t queueFamily() const;

    // What the validation layer has said so far; always empty without it.
    std::vector<std::string> validationMessages() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fringe::gpu
