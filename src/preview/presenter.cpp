#include "preview/presenter.hpp"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_vulkan.h>
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace fringe::preview {
namespace {

constexpr std::uint64_t kTimeout_ns = 60'000'000'000;
constexpr std::uint32_t kFramesOfWidgets = 3;  // vertex buffers that the widgets' backend cycles through

using Stage = vk::PipelineStageFlagBits;
using Use = vk::AccessFlagBits;
using Layout = vk::ImageLayout;

constexpr vk::ImageSubresourceRange kWhole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
constexpr vk::ImageSubresourceLayers kLayer(vk::ImageAspectFlagBits::eColor, 0, 0, 1);

vk::raii::SurfaceKHR createSurface(const gpu::Device& device, const Window& window) {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    const auto instance = static_cast<VkInstance>(*device.instance());
    if (glfwCreateWindowSurface(instance, window.handle(), nullptr, &surface) != VK_SUCCESS) {
        const char* reason = nullptr;
        glfwGetError(&reason);
        throw WindowError(fmt::format("Vulkan cannot draw into this window: {}",
                                      reason != nullptr ? reason : "no reason given"));
    }
    return {device.instance(), surface};
}

bool canShow(const gpu::Device& device, const Window& window) {
    const vk::raii::SurfaceKHR surface = createSurface(device, window);
    return device.physical().getSurfaceSupportKHR(device.queueFamily(), *surface) == VK_TRUE;
}

// The device asked for, else the first that can show the window: a GPU without a display may render for one
// that a processor draws.
gpu::Device openDevice(const Window& window, const gpu::DeviceRequest& request) {
    try {
        gpu::Device device(request);
        if (canShow(device, window)) return device;
    } catch (const gpu::DeviceError&) {  // it may render without being able to show
    }
    const std::size_t count = gpu::listDevices().size();
    for (std::size_t i = 0; i < count; ++i) {
        gpu::DeviceRequest other = request;
        other.selector = fmt::to_string(i);
        try {
            gpu::Device device(other);
            if (canShow(device, window)) return device;
        } catch (const gpu::DeviceError&) {  // the next one, then
        }
    }
    throw gpu::DeviceError(
        "no Vulkan device of this machine can show pictures in windows of this display; fringe render writes "
        "them to files");
}

// Draws over what is there, and makes it ready to be shown.
vk::raii::RenderPass createPass(const gpu::Device& device, vk::Format format) {
    const vk::AttachmentDescription color({}, format, vk::SampleCountFlagBits::e1,
                                          vk::AttachmentLoadOp::eLoad, vk::AttachmentStoreOp::eStore,
                                          vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare,
                                          Layout::eTransferDstOptimal, Layout::ePresentSrcKHR);
    const vk::AttachmentReference reference(0, Layout::eColorAttachmentOptimal);
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
    const vk::SubpassDependency afterPicture(VK_SUBPASS_EXTERNAL, 0, Stage::eTransfer,
                                             Stage::eColorAttachmentOutput, Use::eTransferWrite,
                                             Use::eColorAttachmentRead | Use::eColorAttachmentWrite);
    return {device.handle(), vk::RenderPassCreateInfo({}, color, subpass, afterPicture)};
}

vk::raii::DescriptorPool createDescriptors(const gpu::Device& device) {
    const vk::DescriptorPoolSize size(vk::DescriptorType::eCombinedImageSampler, 1);
    return {device.handle(), {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size}};
}

vk::raii::CommandBuffer createCommands(const gpu::Device& device) {
    return std::move(vk::raii::CommandBuffers(
        device.handle(), {*device.commandPool(), vk::CommandBufferLevel::ePrimary, 1})[0]);
}

struct Work {
    vk::PipelineStageFlags stage;
    vk::AccessFlags use;
    Layout layout;
};

constexpr Work kWritten{Stage::eTransfer, Use::eTransferWrite, Layout::eTransferDstOptimal};

void change(const vk::raii::CommandBuffer& commands, vk::Image image, const Work& before, const Work& after) {
    const vk::ImageMemoryBarrier barrier(before.use, after.use, before.layout, after.layout,
                                         VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, image, kWhole);
    commands.pipelineBarrier(before.stage, after.stage, {}, nullptr, nullptr, barrier);
}

// A window that is changing its size may be smaller than the picture's place, for a frame.
bool isWithin(const Rectangle& place, vk::Extent2D size) {
    return place.x >= 0 && place.y >= 0 && place.width > 0 && place.height > 0 &&
           std::int64_t{place.x} + place.width <= size.width &&
           std::int64_t{place.y} + place.height <= size.height;
}

// The last corner of a picture, as blits have it.
vk::Offset3D corner(std::int64_t x, std::int64_t y) {
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 1};
}

void startWidgets(const gpu::Device& device, vk::RenderPass pass, vk::DescriptorPool descriptors,
                  const vk::raii::CommandBuffer& commands) {
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = static_cast<VkInstance>(*device.instance());
    info.PhysicalDevice = static_cast<VkPhysicalDevice>(*device.physical());
    info.Device = static_cast<VkDevice>(*device.handle());
    info.QueueFamily = device.queueFamily();
    info.Queue = static_cast<VkQueue>(*device.queue());
    info.DescriptorPool = static_cast<VkDescriptorPool>(descriptors);
    info.MinImageCount = info.ImageCount = kFramesOfWidgets;
    info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
    info.CheckVkResultFn = [](VkResult result) {
        if (result < 0)
            throw gpu::DeviceError("Vulkan failed while drawing the panel: " +
                                   vk::to_string(static_cast<vk::Result>(result)));
    };
    ImGui_ImplVulkan_Init(&info, static_cast<VkRenderPass>(pass));
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    ImGui_ImplVulkan_CreateFontsTexture(static_cast<VkCommandBuffer>(*commands));
    commands.end();
    device.queue().submit(vk::SubmitInfo({}, {}, *commands));
    device.handle().waitIdle();
    ImGui_ImplVulkan_DestroyFontUploadObjects();
}

}  // namespace

Presenter::Presenter(const Window& window, const Widgets& /*widgets*/, const gpu::DeviceRequest& request)
    : window_(window),
      device_(openDevice(window, request)),
      surface_(createSurface(device_, window)),
      format_(displayFormat(device_, *surface_)),
      pass_(createPass(device_, format_.format)),
      descriptors_(createDescriptors(device_)),
      commands_(createCommands(device_)),
      free_(device_.handle(), vk::SemaphoreCreateInfo()),
      done_(device_.handle(), vk::FenceCreateInfo(vk::FenceCreateFlagBits::eSignaled)) {
    gpu::guarded("starting the panel", [&] {
        startWidgets(device_, *pass_, *descriptors_, commands_);
        warmUp();
    });
}

Presenter::~Presenter() {
    waitUntilIdle();
    ImGui_ImplVulkan_Shutdown();
}

void Presenter::waitUntilIdle() const {
    try {
        device_.handle().waitIdle();
    } catch (const vk::Error&) {  // a lost device is idle, too
    }
}

void Presenter::beginWidgets() const {
    ImGui_ImplVulkan_NewFrame();
}

Presenter::Image Presenter::createImage(vk::Extent2D size) const {
    using Usage = vk::ImageUsageFlagBits;
    vk::raii::Image image(
        device_.handle(),
        vk::ImageCreateInfo({}, vk::ImageType::e2D, format_.format, {size.width, size.height, 1}, 1, 1,
                            vk::SampleCountFlagBits::e1, vk::ImageTiling::eOptimal,
                            Usage::eTransferDst | Usage::eTransferSrc));
    const vk::MemoryRequirements needs = image.getMemoryRequirements();
    const auto type =
        gpu::memoryType(device_, needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    vk::raii::DeviceMemory memory(device_.handle(), {needs.size, type.value_or(0)});
    image.bindMemory(*memory, 0);
    return {std::move(image), std::move(memory)};
}

Presenter::Picture Presenter::createPicture(std::uint32_t width, std::uint32_t height) const {
    return {width, height, gpu::Buffer(device_, vk::DeviceSize{4} * width * height, gpu::Access::hostWrites),
            createImage({width, height})};
}

// Drivers for processors compile a blit when it is first drawn, lavapipe apart for sides that are powers of
// two and for others. Beside the renderer that took 110 ms of a frame; so it is done before the window is
// there.
void Presenter::warmUp() {
    constexpr std::uint32_t kEnlarged = 5;
    const Image target = createImage({kEnlarged, kEnlarged});
    for (const std::uint32_t width : {3, 4}) {
        for (const std::uint32_t height : {3, 4}) {
            setPicture(width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height));
            commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
            change(commands_, *target.handle, {Stage::eTransfer, {}, Layout::eUndefined}, kWritten);
            recordPicture(*target.handle, {0, 0, kEnlarged, kEnlarged});
            commands_.end();
            device_.queue().submit(vk::SubmitInfo({}, {}, *commands_));
            device_.handle().waitIdle();
        }
    }
    picture_.reset();
}

void Presenter::setPicture(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba) {
    gpu::guarded("showing a picture", [&] {
        waitForFrame();
        if (!picture_ || picture_->width != width || picture_->height != height) {
            picture_.reset();
            picture_.emplace(createPicture(width, height));
        }
        // Written only: reading what a device shares is slow.
        const std::span<std::byte> staging = picture_->staging.mapped();
        const std::size_t red = format_.format == vk::Format::eB8G8R8A8Unorm ? 2 : 0;
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            staging[i + red] = std::byte{rgba[i]};
            staging[i + 1] = std::byte{rgba[i + 1]};
            staging[i + 2 - red] = std::byte{rgba[i + 2]};
        }
        picture_->uploaded = false;
    });
}

void Presenter::waitForFrame() const {
    if (device_.handle().waitForFences(*done_, VK_TRUE, kTimeout_ns) == vk::Result::eTimeout)
        throw gpu::DeviceError(device_.description().name + " has not shown a picture for a minute");
}

void Presenter::resize(Extent size) {
    waitUntilIdle();
    const vk::SwapchainKHR old = swapchain_ ? swapchain_->handle() : vk::SwapchainKHR();
    Swapchain next(device_, *surface_, format_, *pass_,
                   {static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)}, old);
    swapchain_ = std::move(next);
    swapchainFor_ = size;
}

bool Presenter::draw(const Rectangle& place, float background, ImDrawData* widgets) {
    const Extent size = window_.pixels();
    if (size.width == 0 || size.height == 0) return false;
    return gpu::guarded("drawing the window", [&] {
        waitForFrame();
        if (!swapchain_ || swapchainFor_ != size) resize(size);
        try {
            const auto [result, index] = swapchain_->acquire(*free_);
            record(index, place, background, widgets);
            device_.handle().resetFences(*done_);
            const vk::PipelineStageFlags when = Stage::eTransfer;
            const vk::Semaphore free = *free_, drawn = swapchain_->drawn(index);
            device_.queue().submit(vk::SubmitInfo(free, when, *commands_, drawn), *done_);
            const vk::SwapchainKHR swapchain = swapchain_->handle();
            const vk::Result shown = device_.queue().presentKHR(vk::PresentInfoKHR(drawn, swapchain, index));
            if (result == vk::Result::eSuboptimalKHR || shown == vk::Result::eSuboptimalKHR)
                swapchainFor_ = {0, 0};
            return true;
        } catch (const vk::OutOfDateKHRError&) {
            swapchainFor_ = {0, 0};  // the next frame has a new one
            return false;
        }
    });
}

void Presenter::record(std::uint32_t index, const Rectangle& place, float background, ImDrawData* widgets) {
    const vk::Image target = swapchain_->image(index);
    commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    change(commands_, target, {Stage::eTransfer, {}, Layout::eUndefined}, kWritten);
    const vk::ClearColorValue grey(std::array{background, background, background, 1.0F});
    commands_.clearColorImage(target, Layout::eTransferDstOptimal, grey, kWhole);
    if (picture_ && isWithin(place, swapchain_->size())) recordPicture(target, place);
    const vk::Rect2D area({0, 0}, swapchain_->size());
    commands_.beginRenderPass(vk::RenderPassBeginInfo(*pass_, swapchain_->framebuffer(index), area),
                              vk::SubpassContents::eInline);
    ImGui_ImplVulkan_RenderDrawData(widgets, static_cast<VkCommandBuffer>(*commands_));
    commands_.endRenderPass();
    commands_.end();
}

// Pixel for pixel where it fits, enlarged or reduced smoothly where it does not.
void Presenter::recordPicture(vk::Image target, const Rectangle& place) {
    const std::uint32_t width = picture_->width, height = picture_->height;
    const vk::Buffer staging = picture_->staging.handle();
    change(commands_, target, kWritten, kWritten);  // after clearing
    if (place.width == width && place.height == height) {
        const vk::BufferImageCopy there(0, 0, 0, kLayer, {place.x, place.y, 0}, {width, height, 1});
        commands_.copyBufferToImage(staging, target, Layout::eTransferDstOptimal, there);
        return;
    }
    const vk::Image image = *picture_->image.handle;
    if (!picture_->uploaded) {
        const Work read{Stage::eTransfer, Use::eTransferRead, Layout::eTransferSrcOptimal};
        change(commands_, image, {Stage::eTransfer, Use::eTransferRead, Layout::eUndefined}, kWritten);
        const vk::BufferImageCopy all(0, 0, 0, kLayer, {}, {width, height, 1});
        commands_.copyBufferToImage(staging, image, Layout::eTransferDstOptimal, all);
        change(commands_, image, kWritten, read);
        picture_->uploaded = true;
    }
    const std::array<vk::Offset3D, 2> from{vk::Offset3D(0, 0, 0), corner(width, height)};
    const std::array<vk::Offset3D, 2> to{
        vk::Offset3D(place.x, place.y, 0),
        corner(std::int64_t{place.x} + place.width, std::int64_t{place.y} + place.height)};
    commands_.blitImage(image, Layout::eTransferSrcOptimal, target, Layout::eTransferDstOptimal,
                        vk::ImageBlit(kLayer, from, kLayer, to), vk::Filter::eLinear);
}

}  // namespace fringe::preview
