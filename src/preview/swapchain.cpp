#include "preview/swapchain.hpp"

#include <algorithm>

namespace fringe::preview {
namespace {

// Newest picture first where the display can do that, for then a turned knob shows at once; else in their
// order, which every display can.
vk::PresentModeKHR presentMode(const gpu::Device& device, vk::SurfaceKHR surface) {
    const auto modes = device.physical().getSurfacePresentModesKHR(surface);
    const auto newest = std::find(modes.begin(), modes.end(), vk::PresentModeKHR::eMailbox);
    return newest != modes.end() ? *newest : vk::PresentModeKHR::eFifo;
}

vk::Extent2D sizeWithin(const vk::SurfaceCapabilitiesKHR& able, vk::Extent2D size) {
    return {std::clamp(size.width, able.minImageExtent.width, able.maxImageExtent.width),
            std::clamp(size.height, able.minImageExtent.height, able.maxImageExtent.height)};
}

vk::CompositeAlphaFlagBitsKHR alpha(const vk::SurfaceCapabilitiesKHR& able) {
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    return able.supportedCompositeAlpha & Alpha::eOpaque ? Alpha::eOpaque : Alpha::eInherit;
}

vk::raii::SwapchainKHR create(const gpu::Device& device, vk::SurfaceKHR surface, vk::SurfaceFormatKHR format,
                              vk::Extent2D size, vk::SwapchainKHR old) {
    const auto able = device.physical().getSurfaceCapabilitiesKHR(surface);
    std::uint32_t count = std::max(3U, able.minImageCount);
    if (able.maxImageCount > 0) count = std::min(count, able.maxImageCount);
    using Usage = vk::ImageUsageFlagBits;
    const vk::SwapchainCreateInfoKHR info({}, surface, count, format.format, format.colorSpace, size, 1,
                                          Usage::eColorAttachment | Usage::eTransferDst,
                                          vk::SharingMode::eExclusive, {}, able.currentTransform, alpha(able),
                                          presentMode(device, surface), VK_TRUE, old);
    return {device.handle(), info};
}

}  // namespace

Swapchain::Swapchain(const gpu::Device& device, vk::SurfaceKHR surface, vk::SurfaceFormatKHR format,
                     vk::RenderPass pass, vk::Extent2D size, vk::SwapchainKHR old)
    : size_(sizeWithin(device.physical().getSurfaceCapabilitiesKHR(surface), size)),
      swapchain_(create(device, surface, format, size_, old)) {
    for (const VkImage image : swapchain_.getImages()) images_.emplace_back(image);
    for (const vk::Image image : images_) {
        const vk::ImageSubresourceRange whole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
        views_.emplace_back(device.handle(), vk::ImageViewCreateInfo({}, image, vk::ImageViewType::e2D,
                                                                     format.format, {}, whole));
        const vk::ImageView view = *views_.back();
        framebuffers_.emplace_back(device.handle(),
                                   vk::FramebufferCreateInfo({}, pass, view, size_.width, size_.height, 1));
        drawn_.emplace_back(device.handle(), vk::SemaphoreCreateInfo());
    }
}

std::pair<vk::Result, std::uint32_t> Swapchain::acquire(vk::Semaphore free) const {
    constexpr std::uint64_t kForever = ~std::uint64_t{0};
    return swapchain_.acquireNextImage(kForever, free);
}

vk::SurfaceFormatKHR displayFormat(const gpu::Device& device, vk::SurfaceKHR surface) {
    for (const vk::SurfaceFormatKHR format : device.physical().getSurfaceFormatsKHR(surface)) {
        const bool eightBits =
            format.format == vk::Format::eB8G8R8A8Unorm || format.format == vk::Format::eR8G8B8A8Unorm;
        if (eightBits && format.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear) return format;
    }
    throw gpu::DeviceError(device.description().name + " shows no sRGB pictures of 8 bits a channel here");
}

}  // namespace fringe::preview
