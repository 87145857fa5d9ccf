#include "render/progressive.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <span>

#include "render/stopwatch.hpp"
#include "render/tiling.hpp"

namespace fringe::render {
namespace {

constexpr double kDispatch_ms = 30.0;      // then a new wish of the user's is looked at
constexpr std::uint64_t kProbe = 1 << 14;  // pixels of a first dispatch, whose time is not known
constexpr std::uint32_t kMostSamplesAtOnce = 64;
constexpr std::size_t kPipelinesKept = 8;

}  // namespace

struct Progressive::Pipeline {
    Variant variant;
    device::Specialisation constants;
    ShaderCode shader;
    gpu::Kernel kernel;
    double pixel_ms = 0.0;  // of a sample of a pixel; 0: not known yet
};

Progressive::Progressive(const gpu::Device& device) : device_(device) {}
Progressive::~Progressive() = default;

std::uint64_t Progressive::mostPixels() const {
    return Film::pixelsIn(device_.limits().maxStorageBufferRange);
}

void Progressive::show(const compile::CompiledScene& scene, device::Specialisation constants,
                       const ShaderCode& shader) {
    constants = specialiseFor(device_, scene, constants);
    frame_ = scene.frame;
    const SceneLayout layout = layOut(scene, device_);
    if (!scene_ || scene_->size() < layout.size)
        scene_.emplace(device_, layout.size, gpu::Access::hostWrites);
    upload(layout, *scene_);
    uploadTexels(device_, scene, constants, texels_);
    const std::uint64_t pixels = std::uint64_t{frame_.filmWidth} * wholeGroups(frame_.height);
    if (!film_ || film_->pixels() < pixels) film_.emplace(device_, pixels);
    pipelineFor(variantFor(scene), constants, shader, layout)
        .kernel.bind(bindings(layout, *scene_, film_->buffer(), texels_));
    restart();
}

Progressive::Pipeline& Progressive::pipelineFor(const Variant& variant,
                                                const device::Specialisation& constants,
                                                const ShaderCode& shader, const SceneLayout& layout) {
    const auto found = std::find_if(pipelines_.begin(), pipelines_.end(), [&](const auto& pipeline) {
        return pipeline->variant == variant && pipeline->constants == constants && pipeline->shader == shader;
    });
    if (found != pipelines_.end()) {
        std::rotate(found, found + 1, pipelines_.end());
        return *pipelines_.back();
    }
    compile_ms_ = 0.0;
    const Stopwatch watch(compile_ms_);
    std::array<std::uint32_t, device::kSpecialisationCount> values{};
    std::memcpy(values.data(), &constants, sizeof constants);
    const std::span<const std::uint32_t> code = shader ? std::span(*shader) : embeddedShader(variant);
    gpu::Kernel kernel(device_, code, bindings(layout, *scene_, film_->buffer(), texels_), values);
    // Drivers may put off compiling until the first dispatch: one workgroup, which restart() clears away.
    const gpu::Groups corner{0, 0, 0};
    kernel.run({&corner, 1}, {1, 1, 1});
    ++compilations_;
    if (pipelines_.size() == kPipelinesKept) pipelines_.erase(pipelines_.begin());
    pipelines_.push_back(std::make_unique<Pipeline>(Pipeline{variant, constants, shader, std::move(kernel)}));
    return *pipelines_.back();
}

void Progressive::look(const device::Frame& frame) {
    assert(!pipelines_.empty());
    frame_ = frame;
    std::memcpy(scene_->mapped().data() + offsetof(device::SceneBlock, frame), &frame, sizeof frame);
    restart();
}

void Progressive::restart() {
    film_->clear(0, std::uint64_t{frame_.filmWidth} * wholeGroups(frame_.height));
    samples_ = 0;
    nextRow_ = 0;
}

std::optional<double> Progressive::expected_ms(std::uint64_t pixels) const {
    if (pipelines_.empty() || pipelines_.back()->pixel_ms == 0.0) return std::nullopt;
    return pipelines_.back()->pixel_ms * static_cast<double>(pixels);
}

void Progressive::advance(std::uint32_t samples) {
    assert(!pipelines_.empty());
    if (samples_ >= samples) return;
    Pipeline& pipeline = *pipelines_.back();
    const std::uint32_t height = wholeGroups(frame_.height);
    const double affordable =
        pipeline.pixel_ms > 0.0 ? kDispatch_ms / pipeline.pixel_ms : static_cast<double>(kProbe);
    const double wholePictures = affordable / (1.0 * frame_.filmWidth * height);

    // Either some rows of one sample, or all rows of one sample or more.
    std::uint32_t rows = height - nextRow_, count = 1;
    if (wholePictures < 1.0) {
        const auto wanted = static_cast<std::uint32_t>(affordable / frame_.filmWidth);
        rows = std::min(rows, wholeGroups(std::max(wanted, 1U)));
    } else if (nextRow_ == 0) {
        count = static_cast<std::uint32_t>(std::min<double>(wholePictures, kMostSamplesAtOnce));
        count = std::min(count, samples - samples_);
    }
    std::vector<gpu::Groups> firstGroups;
    for (std::uint32_t i = 0; i < count; ++i)
        firstGroups.push_back({0, nextRow_ / device::GROUP_EDGE, samples_ + i});
    double spent_ms = 0.0;
    {
        const Stopwatch watch(spent_ms);
        pipeline.kernel.run(firstGroups,
                            {frame_.filmWidth / device::GROUP_EDGE, rows / device::GROUP_EDGE, 1});
    }
    pipeline.pixel_ms = spent_ms / (1.0 * frame_.filmWidth * rows * count);
    nextRow_ += rows;
    if (nextRow_ == height) {
        nextRow_ = 0;
        samples_ += count;
    }
}

void Progressive::read(std::vector<image::Pixel>& pixels) {
    pixels.clear();
    film_->read(frame_, frame_.height, pixels);
}

}  // namespace fringe::render
