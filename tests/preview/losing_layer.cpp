// A Vulkan layer between the program and its driver that loses things on command, as a driver does when a
// device is reset or unplugged. The file that FRINGE_LOSE names says what: "renderer", the next device
// without swapchains that gets work; "window", the next with them; "surface", that of the next picture that
// is to be shown. It is taken away when that has happened. Whatever is lost stays so: for a device, every
// later call that may say so does.
#define VK_NO_PROTOTYPES
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace {

struct Device {
    PFN_vkGetDeviceProcAddr next = nullptr;
    VkDevice handle = VK_NULL_HANDLE;
    bool isLost = false, shows = false;
};

std::mutex mutex;
std::map<void*, Device> devices;                       // by what the loader dispatches by, which queues share
std::map<void*, PFN_vkGetInstanceProcAddr> instances;  // likewise
std::map<void*, VkInstance> instanceHandles;

template <class Handle>
void* keyOf(Handle handle) {
    void* key = nullptr;
    std::memcpy(&key, handle, sizeof key);
    return key;
}

template <class Handle>
Device& deviceOf(Handle handle) {
    const std::scoped_lock lock(mutex);
    return devices[keyOf(handle)];
}

template <class Function>
Function nextOf(const Device& device, const char* name) {
    return reinterpret_cast<Function>(device.next(device.handle, name));
}

// Whether this is to be lost now; the command is then carried out.
bool isCommanded(const char* what) {
    const char* file = std::getenv("FRINGE_LOSE");
    std::string command;
    if (file == nullptr || !(std::ifstream(file) >> command) || command != what) return false;
    return std::filesystem::remove(file);
}

// The link of the chain that this layer is to take out of the create info.
template <class Link, class Info>
Link* linkOf(const Info* info, VkStructureType type) {
    for (auto* each = static_cast<const VkBaseInStructure*>(info->pNext); each != nullptr;
         each = each->pNext) {
        auto* link = const_cast<Link*>(reinterpret_cast<const Link*>(each));
        if (each->sType == type && link->function == VK_LAYER_LINK_INFO) return link;
    }
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator, VkInstance* instance) {
    auto* link = linkOf<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(next(VK_NULL_HANDLE, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    const std::scoped_lock lock(mutex);
    if (result == VK_SUCCESS) {
        instances[keyOf(*instance)] = next;
        instanceHandles[keyOf(*instance)] = *instance;
    }
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkDevice* device) {
    auto* link = linkOf<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr nextInstance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    Device made{.next = link->u.pLayerInfo->pfnNextGetDeviceProcAddr};
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const std::scoped_lock lock(mutex);
    const VkInstance instance = instanceHandles[keyOf(physical)];
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(nextInstance(instance, "vkCreateDevice"));
    const VkResult result = create(physical, info, allocator, device);
    if (result != VK_SUCCESS) return result;
    made.handle = *device;
    for (std::uint32_t i = 0; i < info->enabledExtensionCount; ++i)
        made.shows = made.shows ||
                     std::string_view(info->ppEnabledExtensionNames[i]) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    devices[keyOf(*device)] = made;
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL queueSubmit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* infos,
                                           VkFence fence) {
    Device& device = deviceOf(queue);
    device.isLost = device.isLost || isCommanded(device.shows ? "window" : "renderer");
    if (device.isLost) return VK_ERROR_DEVICE_LOST;
    return nextOf<PFN_vkQueueSubmit>(device, "vkQueueSubmit")(queue, count, infos, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL waitForFences(VkDevice handle, std::uint32_t count, const VkFence* fences,
                                             VkBool32 all, std::uint64_t timeout) {
    const Device& device = deviceOf(handle);
    if (device.isLost) return VK_ERROR_DEVICE_LOST;
    return nextOf<PFN_vkWaitForFences>(device, "vkWaitForFences")(handle, count, fences, all, timeout);
}

VKAPI_ATTR VkResult VKAPI_CALL deviceWaitIdle(VkDevice handle) {
    const Device& device = deviceOf(handle);
    const VkResult result = nextOf<PFN_vkDeviceWaitIdle>(device, "vkDeviceWaitIdle")(handle);
    return device.isLost ? VK_ERROR_DEVICE_LOST : result;
}

VKAPI_ATTR VkResult VKAPI_CALL queuePresent(VkQueue queue, const VkPresentInfoKHR* info) {
    const Device& device = deviceOf(queue);
    const VkResult result = nextOf<PFN_vkQueuePresentKHR>(device, "vkQueuePresentKHR")(queue, info);
    return isCommanded("surface") ? VK_ERROR_SURFACE_LOST_KHR : result;
}

PFN_vkVoidFunction ownFunction(std::string_view name);

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
    if (const PFN_vkVoidFunction own = ownFunction(name)) return own;
    return deviceOf(device).next(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
    if (const PFN_vkVoidFunction own = ownFunction(name)) return own;
    if (instance == VK_NULL_HANDLE) return nullptr;
    const std::scoped_lock lock(mutex);
    return instances[keyOf(instance)](instance, name);
}

PFN_vkVoidFunction ownFunction(std::string_view name) {
    const auto as = [](auto function) { return reinterpret_cast<PFN_vkVoidFunction>(function); };
    if (name == "vkGetInstanceProcAddr") return as(getInstanceProcAddr);
    if (name == "vkGetDeviceProcAddr") return as(getDeviceProcAddr);
    if (name == "vkCreateInstance") return as(createInstance);
    if (name == "vkCreateDevice") return as(createDevice);
    if (name == "vkQueueSubmit") return as(queueSubmit);
    if (name == "vkWaitForFences") return as(waitForFences);
    if (name == "vkDeviceWaitIdle") return as(deviceWaitIdle);
    if (name == "vkQueuePresentKHR") return as(queuePresent);
    return nullptr;
}

}  // namespace

extern "C" VK_LAYER_EXPORT VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = getInstanceProcAddr;
    version->pfnGetDeviceProcAddr = getDeviceProcAddr;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
