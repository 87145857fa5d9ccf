// The pictures that a window shows in turn, and what is needed to draw into them.
#pragma once

#include <vector>

#include "gpu/vulkan.hpp"

namespace fringe::preview {

class Swapchain {
public:
    // For a surface of this size in pixels, in place of `old`, which may be null. Throws vk::Error.
    Swapchain(const gpu::Device& device, vk::SurfaceKHR surface, vk::SurfaceFormatKHR format,
              vk::RenderPass pass, vk::Extent2D size, vk::SwapchainKHR old);

    vk::SwapchainKHR handle() const { return *swapchain_; }
    vk::Extent2D size() const { return size_; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(images_.size()); }
    vk::Image image(std::uint32_t i) const { return images_[i]; }
    vk::Framebuffer framebuffer(std::uint32_t i) const { return *framebuffers_[i]; }

    // Signalled when picture i has been drawn.
    vk::Semaphore drawn(std::uint32_t i) const { return *drawn_[i]; }

    // Waits for a picture to draw into, which is free once `free` is signalled. Throws vk::OutOfDateKHRError.
    std::pair<vk::Result, std::uint32_t> acquire(vk::Semaphore free) const;

private:
    vk::Extent2D size_;
    vk::raii::SwapchainKHR swapchain_;
    std::vector<vk::Image> images_;
    std::vector<vk::raii::ImageView> views_;
    std::vector<vk::raii::Framebuffer> framebuffers_;
    std::vector<vk::raii::Semaphore> drawn_;
};

// 8 bits a channel, shown as they are: pictures come developed. Throws gpu::DeviceError.
vk::SurfaceFormatKHR displayFormat(const gpu::Device& device, vk::SurfaceKHR surface);

}  // namespace fringe::preview
