// Shows a picture and Dear ImGui's widgets in a window. It has a Vulkan device of its own, apart from the one
// that renders: a window then answers while a long dispatch or a compilation is under way, also where the
// processor is the device, and where the renderer's device has no display.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "gpu/buffer.hpp"
#include "preview/swapchain.hpp"
#include "preview/widgets.hpp"
#include "preview/window.hpp"

struct ImDrawData;

namespace fringe::preview {

// Where in the window the picture is, in pixels.
struct Rectangle {
    std::int32_t x, y;
    std::uint32_t width, height;
};

class Presenter {
public:
    // Keeps a reference to the window. On the device asked for if that can show the window, else on another.
    // Throws gpu::DeviceError or WindowError.
    Presenter(const Window& window, const Widgets& widgets, const gpu::DeviceRequest& request);
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    // To be called before Widgets::begin().
    void beginWidgets() const;

    // From now on this is the picture: red, green, blue and a byte that does not count, of each pixel.
    void setPicture(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba);

    // Draws the picture there, scaled, on `background` (grey, 0 to 1), and the widgets over it. False if
    // there is nothing to draw on at the moment: the window is minimised or is changing its size.
    bool draw(const Rectangle& place, float background, ImDrawData* widgets);

    const gpu::Device& device() const { return device_; }

private:
    // In the window's format.
    struct Image {
        vk::raii::Image handle;
        vk::raii::DeviceMemory memory;
    };

    struct Picture {
        std::uint32_t width, height;
        gpu::Buffer staging;  // in the order of the window's channels
        Image image;
        bool uploaded = false;
    };

    Image createImage(vk::Extent2D size) const;
    Picture createPicture(std::uint32_t width, std::uint32_t height) const;
    void warmUp();
    void resize(Extent size);
    void record(std::uint32_t index, const Rectangle& place, float background, ImDrawData* widgets);
    void recordPicture(vk::Image target, const Rectangle& place);
    void waitUntilIdle() const;
    void waitForFrame() const;

    const Window& window_;
    gpu::Device device_;
    vk::raii::SurfaceKHR surface_;
    vk::SurfaceFormatKHR format_;
    vk::raii::RenderPass pass_;
    vk::raii::DescriptorPool descriptors_;  // of the widgets' font
    std::optional<Swapchain> swapchain_;
    Extent swapchainFor_{0, 0};  // the window's size then
    std::optional<Picture> picture_;
    vk::raii::CommandBuffer commands_;
    vk::raii::Semaphore free_;  // the acquired picture may be drawn into
    vk::raii::Fence done_;      // of the last frame
};

}  // namespace fringe::preview
