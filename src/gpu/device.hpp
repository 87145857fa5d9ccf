// A Vulkan 1.2 device with one compute queue, chosen and ready to work, or a DeviceError that says why not.
// Everything of Vulkan stays inside src/gpu and src/preview; failures of the driver leave them as
// DeviceError.
#pragma once

#define VK_NO_PROTOTYPES  // the loader is opened at run time, so that a machine without one gets a message
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

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

// What the validation layer says; the driver calls add() from any thread.
class ValidationLog {
public:
    void add(std::string text);
    std::vector<std::string> texts() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> texts_;
};

class Device {
public:
    explicit Device(const DeviceRequest& request);

    const DeviceDescription& description() const { return description_; }
    const vk::raii::Device& handle() const { return device_; }
    const vk::raii::Queue& queue() const { return queue_; }
    const vk::raii::CommandPool& commandPool() const { return commandPool_; }
    const vk::PhysicalDeviceLimits& limits() const { return limits_; }
    const vk::raii::Instance& instance() const { return instance_; }
    const vk::raii::PhysicalDevice& physical() const { return physical_; }
    std::uint32_t queueFamily() const { return queueFamily_; }

    // Index of the first memory type allowed by `typeBits` that has all the properties.
    std::optional<std::uint32_t> memoryType(std::uint32_t typeBits, vk::MemoryPropertyFlags properties) const;

    // What the validation layer has said so far; always empty without it.
    std::vector<std::string> validationMessages() const { return validation_->texts(); }

private:
    vk::raii::Context context_;
    std::unique_ptr<ValidationLog>
        validation_;  // on the heap: the driver keeps its address when the Device moves
    vk::raii::Instance instance_;
    vk::raii::DebugUtilsMessengerEXT messenger_;
    vk::raii::PhysicalDevice physical_;
    DeviceDescription description_;
    vk::PhysicalDeviceLimits limits_;
    vk::PhysicalDeviceMemoryProperties memory_;
    std::uint32_t queueFamily_;
    vk::raii::Device device_;
    vk::raii::Queue queue_;
    vk::raii::CommandPool commandPool_;
};

}  // namespace fringe::gpu
