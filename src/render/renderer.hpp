// Renders a compiled scene on a device: dispatches tiles and sample batches, and hands on the picture band by
// band, so that neither the device nor the host ever holds a whole large picture.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "compile/compiled_scene.hpp"
#include "compile/lit_tiles.hpp"
#include "image/image.hpp"

namespace fringe::gpu {
class Device;
}

namespace fringe::render {

// Rows firstRow.. of the picture, whole ones.
struct Band {
    std::uint32_t firstRow;
    std::uint32_t rowCount;
    std::span<const image::Pixel> pixels;
};

struct Control {
    const std::atomic<bool>& cancelled;      // polled between dispatches, each about 50 ms
    std::function<void(double)> onProgress;  // share of the work done, 0..1; called after every dispatch
    std::function<void(const Band&)>
        onBand;              // in order from the top; after a cancellation once more, with what is there
    std::uint32_t tile = 0;  // edge of a tile in pixels; 0: as large as one dispatch may last
};

// How the values of a scene, but for arrays of more than FEW, reach the shader.
enum class Values {
    inUniforms,   // a pipeline serves every scene of the same Specialisation, as turning a knob needs
    asConstants,  // compiled in: the pipeline is for this scene alone, and the driver folds what it can
};

// Wall-clock milliseconds on the host, from asking to having.
struct Clocks {
    double compile = 0.0;  // pipeline and first dispatch, of one workgroup: drivers compile in either
    double upload = 0.0;
    double dispatch = 0.0;  // with clearing the film
    double readback = 0.0;  // to host memory, and the mean over the samples
    std::uint64_t dispatches = 0;
};

class Renderer {
public:
    // Keeps a reference to the device. Where it pays, tiles that are known not to be lit by gratings get a
    // pipeline without them; the picture is the same. Throws gpu::DeviceError.
    Renderer(const gpu::Device& device, const compile::CompiledScene& scene,
             const device::Specialisation& specialisation, Values values, compile::LitTiles litTiles = {});

    ~Renderer();

    // The same pixels for every tile size. Returns false if it was cancelled.
    bool render(const Control& control);

    const Clocks& clocks() const;

private:
    class Pass;
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fringe::render
