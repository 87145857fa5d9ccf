#include "gpu/device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <mutex>
#include <optional>

#include "gpu/vulkan.hpp"

namespace fringe::gpu {

// What the validation layer says; the driver calls add() from any thread.
class ValidationLog {
public:
    void add(std::string text) {
        const std::scoped_lock lock(mutex_);
        texts_.push_back(std::move(text));
    }
    std::vector<std::string> texts() const {
        const std::scoped_lock lock(mutex_);
        return texts_;
    }

private:
    mutable std::mutex mutex_;
    std::vector<std::string> texts_;
};

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::uint32_t kStorageBuffers = 16;  // bindings 1..16 of shaders/bindings.glsl
constexpr std::uint32_t kWorkgroupInvocations = 64;

// ---- instance -----------------------------------------------------------------------------------

vk::raii::Context openLoader() {
    try {
        return vk::raii::Context();
    } catch (const std::exception&) {
        throw DeviceError(
            "no Vulkan loader (libvulkan.so.1) on this machine; install one together with a driver, on "
            "Debian: "
            "apt-get install libvulkan1 mesa-vulkan-drivers");
    }
}

bool hasValidationLayer(const vk::raii::Context& context) {
    const auto layers = context.enumerateInstanceLayerProperties();
    return std::any_of(layers.begin(), layers.end(), [](const auto& layer) {
        return std::string_view(layer.layerName) == kValidationLayer;
    });
}

vk::raii::Instance createInstance(const vk::raii::Context& context, bool validation,
                                  std::vector<const char*> extensions) {
    if (validation && !hasValidationLayer(context)) {
        throw DeviceError(
            "validation was asked for, but the layer VK_LAYER_KHRONOS_validation is not installed; on "
            "Debian: "
            "apt-get install vulkan-validationlayers");
    }
    const vk::ApplicationInfo application("fringe", 1, "fringe", 1, VK_API_VERSION_1_2);
    const std::array layers{kValidationLayer};
    if (validation) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    const std::array checks{vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    const vk::ValidationFeaturesEXT features(checks);
    vk::InstanceCreateInfo info({}, &application, {}, extensions);
    if (validation) info.setPEnabledLayerNames(layers).setPNext(&features);
    try {
        return {context, info};
    } catch (const vk::IncompatibleDriverError&) {
        throw DeviceError(
            "no Vulkan driver on this machine; install one, on Debian: apt-get install mesa-vulkan-drivers "
            "(its lavapipe renders on the CPU)");
    } catch (const vk::Error& error) {
        throw DeviceError(std::string("Vulkan cannot start: ") + error.what());
    }
}

// A window that is resized between the question for its size and the making of its swapchain: nothing that
// the caller could prevent (Khronos' Vulkan-Docs, issue 1144). The driver tells it as a swapchain out of
// date.
constexpr std::string_view kResizedMeanwhile = "VUID-VkSwapchainCreateInfoKHR-imageExtent-01274";

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* log) {
    if (data->pMessageIdName == nullptr || data->pMessageIdName != kResizedMeanwhile)
        static_cast<ValidationLog*>(log)->add(data->pMessage);
    return VK_FALSE;
}

vk::raii::DebugUtilsMessengerEXT createMessenger(const vk::raii::Instance& instance, bool validation,
                                                 ValidationLog* log) {
    if (!validation) return nullptr;
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return {instance,
            {{},
             Severity::eWarning | Severity::eError,
             Type::eGeneral | Type::eValidation | Type::ePerformance,
             onMessage,
             log}};
}

// ---- what a physical device offers --------------------------------------------------------------

std::string typeName(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return "discrete GPU";
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return "integrated GPU";
        case vk::PhysicalDeviceType::eVirtualGpu:
            return "virtual GPU";
        case vk::PhysicalDeviceType::eCpu:
            return "CPU";
        default:
            return "other";
    }
}

int preference(const DeviceDescription& device) {
    constexpr std::array order{"discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"};
    return static_cast<int>(std::find(order.begin(), order.end(), device.type) - order.begin());
}

// The first family of queues that can do all this.
std::optional<std::uint32_t> familyFor(const vk::raii::PhysicalDevice& physical, vk::QueueFlags work) {
    const auto families = physical.getQueueFamilyProperties();
    for (std::uint32_t i = 0; i < families.size(); ++i) {
        if ((families[i].queueFlags & work) == work) return i;
    }
    return std::nullopt;
}

DeviceDescription describe(const vk::raii::PhysicalDevice& physical) {
    const vk::PhysicalDeviceProperties properties = physical.getProperties();
    const auto version = [](std::uint32_t v) {
        return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(v), VK_API_VERSION_MINOR(v),
                           VK_API_VERSION_PATCH(v));
    };
    DeviceDescription result{.name = properties.deviceName.data(),
                             .type = typeName(properties.deviceType),
                             .driver = {},
                             .vulkan = version(properties.apiVersion),
                             .missing = {}};
    if (properties.apiVersion < VK_API_VERSION_1_2) {
        result.driver = version(properties.driverVersion);
        result.missing.push_back("Vulkan 1.2");
        return result;  // the queries below need it
    }
    const auto chain =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    result.driver = fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
    const auto features =
        physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>();
    if (!features.get<vk::PhysicalDeviceVulkan12Features>().scalarBlockLayout) {
        result.missing.push_back("scalarBlockLayout (a feature of Vulkan 1.2)");
    }
    if (properties.limits.maxPerStageDescriptorStorageBuffers < kStorageBuffers) {
        result.missing.push_back(fmt::format("{} storage buffers in a shader (has {})", kStorageBuffers,
                                             properties.limits.maxPerStageDescriptorStorageBuffers));
    }
    if (properties.limits.maxComputeWorkGroupInvocations < kWorkgroupInvocations) {
        result.missing.push_back(fmt::format("{} invocations in a workgroup", kWorkgroupInvocations));
    }
    if (!familyFor(physical, vk::QueueFlagBits::eCompute)) result.missing.push_back("a compute queue");
    return result;
}

std::vector<vk::raii::PhysicalDevice> physicalDevices(const vk::raii::Instance& instance) {
    vk::raii::PhysicalDevices devices =
        guarded("listing devices", [&] { return vk::raii::PhysicalDevices(instance); });
    if (devices.empty()) {
        throw DeviceError(
            "Vulkan is installed, but its drivers offer no device; install a driver, on Debian: "
            "apt-get install mesa-vulkan-drivers (its lavapipe renders on the CPU)");
    }
    return devices;
}

bool containsIgnoringCase(const std::string& text, const std::string& part) {
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

std::string listing(const std::vector<DeviceDescription>& devices) {
    std::string text;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        text += fmt::format("\n  {}: {} ({})", i, devices[i].name, devices[i].type);
        if (!devices[i].missing.empty())
            text += fmt::format(", lacks {}", fmt::join(devices[i].missing, ", "));
    }
    return text;
}

// Index of the device that `selector` means, or of the best usable one.
std::size_t choose(const std::vector<DeviceDescription>& devices, const std::string& selector) {
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!selector.empty()) {
            if (fmt::to_string(i) == selector || containsIgnoringCase(devices[i].name, selector)) chosen = i;
            if (chosen) break;
        } else if (devices[i].missing.empty() &&
                   (!chosen || preference(devices[i]) < preference(devices[*chosen]))) {
            chosen = i;
        }
    }
    if (!chosen && !selector.empty()) {
        throw DeviceError(fmt::format("no device \"{}\"; there are:{}", selector, listing(devices)));
    }
    if (!chosen) throw DeviceError("none of this machine's devices can run Fringe:" + listing(devices));
    if (!devices[*chosen].missing.empty()) {
        throw DeviceError(fmt::format("{} cannot run Fringe: it lacks {}; there are:{}",
                                      devices[*chosen].name, fmt::join(devices[*chosen].missing, ", "),
                                      listing(devices)));
    }
    return *chosen;
}

vk::raii::PhysicalDevice choosePhysical(const vk::raii::Instance& instance, const std::string& selector) {
    auto all = physicalDevices(instance);
    std::vector<DeviceDescription> descriptions;
    for (const auto& physical : all) descriptions.push_back(describe(physical));
    return std::move(all[choose(descriptions, selector)]);
}

bool hasSwapchains(const vk::raii::PhysicalDevice& physical) {
    const auto extensions = physical.enumerateDeviceExtensionProperties();
    return std::any_of(extensions.begin(), extensions.end(), [](const auto& extension) {
        return std::string_view(extension.extensionName) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    });
}

// Vulkan promises a family that computes as well wherever there is one that draws.
std::uint32_t chooseFamily(const vk::raii::PhysicalDevice& physical, bool shows) {
    using Flag = vk::QueueFlagBits;
    const auto family = familyFor(physical, shows ? Flag::eGraphics | Flag::eCompute : Flag::eCompute);
    if (!family || (shows && !hasSwapchains(physical))) {
        throw DeviceError(fmt::format("{} cannot show pictures in a window (no queue that draws, or no {})",
                                      describe(physical).name, VK_KHR_SWAPCHAIN_EXTENSION_NAME));
    }
    return *family;
}

vk::raii::Device createDevice(const vk::raii::PhysicalDevice& physical, std::uint32_t family, bool shows) {
    return guarded("opening the device", [&] {
        const float priority = 1.0F;
        const vk::DeviceQueueCreateInfo queue({}, family, 1, &priority);
        vk::PhysicalDeviceVulkan12Features features;
        features.scalarBlockLayout = VK_TRUE;
        std::vector<const char*> extensions;
        if (shows) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
        vk::DeviceCreateInfo info({}, queue, {}, extensions);
        info.setPNext(&features);
        return vk::raii::Device(physical, info);
    });
}

}  // namespace

std::vector<DeviceDescription> listDevices() {
    const vk::raii::Context context = openLoader();
    const vk::raii::Instance instance = createInstance(context, false, {});
    std::vector<DeviceDescription> devices;
    for (const auto& physical : physicalDevices(instance)) devices.push_back(describe(physical));
    return devices;
}

struct Device::Parts {
    explicit Parts(const DeviceRequest& request)
        : context(openLoader()),
          instance(createInstance(context, request.validation, request.surfaceExtensions)),
          messenger(createMessenger(instance, request.validation, &validation)),
          physical(choosePhysical(instance, request.selector)),
          description(describe(physical)),
          limits(physical.getProperties().limits),
          queueFamily(chooseFamily(physical, !request.surfaceExtensions.empty())),
          device(createDevice(physical, queueFamily, !request.surfaceExtensions.empty())),
          queue(device, queueFamily, 0),
          commandPool(device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, queueFamily}) {}

    vk::raii::Context context;
    ValidationLog validation;
    vk::raii::Instance instance;
    vk::raii::DebugUtilsMessengerEXT messenger;
    vk::raii::PhysicalDevice physical;
    DeviceDescription description;
    vk::PhysicalDeviceLimits limits;
    std::uint32_t queueFamily;
    vk::raii::Device device;
    vk::raii::Queue queue;
    vk::raii::CommandPool commandPool;
};

Device::Device(const DeviceRequest& request) : parts_(std::make_unique<Parts>(request)) {}
Device::~Device() = default;
Device::Device(Device&&) noexcept = default;

const DeviceDescription& Device::description() const {
    return parts_->description;
}
const vk::raii::Device& Device::handle() const {
    return parts_->device;
}
const vk::raii::Queue& Device::queue() const {
    return parts_->queue;
}
const vk::raii::CommandPool& Device::commandPool() const {
    return parts_->commandPool;
}
const vk::PhysicalDeviceLimits& Device::limits() const {
    return parts_->limits;
}
const vk::raii::Instance& Device::instance() const {
    return parts_->instance;
}
const vk::raii::PhysicalDevice& Device::physical() const {
    return parts_->physical;
}
std::uint32_t Device::queueFamily() const {
    return parts_->queueFamily;
}
std::vector<std::string> Device::validationMessages() const {
    return parts_->validation.texts();
}

std::optional<std::uint32_t> memoryType(const Device& device, std::uint32_t typeBits,
                                        vk::MemoryPropertyFlags properties) {
    const vk::PhysicalDeviceMemoryProperties memory = device.physical().getMemoryProperties();
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        const bool allowed = ((typeBits >> i) & 1U) != 0;
        if (allowed && (memory.memoryTypes[i].propertyFlags & properties) == properties) return i;
    }
    return std::nullopt;
}

}  // namespace fringe::gpu
