#include "preview/rendering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/exposure_meter.hpp"
#include "preview/false_color.hpp"
#include "render/development.hpp"
#include "render/stopwatch.hpp"

namespace fringe::preview {
namespace {

using render::Stopwatch;

// A coarse picture is to be there in this time, so that 25 a second can be with drawing the window as well.
constexpr double kCoarse_ms = 22.0;
constexpr double kFirstPixels = 1 << 14;  // of a coarse picture before anything has been measured
constexpr double kCoarsest = 16.0;
constexpr double kAtOnce_ms = 200.0;  // a full picture that takes no longer comes right after the coarse one

std::uint32_t divided(std::uint32_t side, std::uint32_t divisor) {
    return (side + divisor - 1) / divisor;
}

// The picture that a scene asks for, or a smaller one of the same shape where the film has no room for that.
scene::Image fitted(scene::Image image, std::uint64_t mostPixels) {
    const scene::Image asked = image;
    const auto padded = [](std::uint32_t side) { return std::uint64_t{side} + device::GROUP_EDGE; };
    for (std::uint32_t divisor = 2; padded(image.width) * padded(image.height) > mostPixels; ++divisor) {
        image.width = divided(asked.width, divisor);
        image.height = divided(asked.height, divisor);
    }
    return image;
}

}  // namespace

void Rendering::load(const Wish& wish) {
    tried_ = wish.source;
    triedSwitches_ = wish.switches;
    timing_.scene = 0.0;
    {
        const Stopwatch watch(timing_.scene);
        auto scene = std::make_shared<scene::Scene>(switched(
            scene::parseScene(wish.source->text, wish.source->file, wish.source->overrides), wish.switches));
        const auto development = render::developmentOf(*scene);
        if (!development) {
            throw scene::SceneError({{wish.source->file,
                                      "camera.white_balance: this light is too saturated to look white; give "
                                      "the spectrum of a lamp"}});
        }
        scene->image = fitted(scene->image, progressive_.mostPixels());
        samplesOfScene_ = std::exchange(scene->image.samples, wish.samples);
        memo_.wantDrafts(wish.isMoving);
        compiled_ = compile::compileScene(
            *scene, wish.switches.wavelength_nm ? compile::Measure::radiance : compile::Measure::color,
            &memo_, compile::Viewpoint::moving);
        development_ = *development;
        scene_ = std::move(scene);
    }
    source_ = wish.source;
    wavelength_nm_ = wish.switches.wavelength_nm;
    wish_ = wish;
    takeShader();
    start();
}

// The one for this kind of scene, as the wish has it. True if it is another than before.
bool Rendering::takeShader() {
    if (shaders_ == nullptr) return false;
    const LiveShaders::Shader& shader = shaders_->of(render::variantFor(compiled_), wish_.shaders);
    shaderError_ = shader.error;
    return std::exchange(shader_, shader.code) != shader.code;
}

// The pipeline and the picture, from the beginning.
void Rendering::start() {
    image_ = scene_->image;
    image_.samples = wish_.samples;
    camera_ = wish_.camera.value_or(scene_->camera);
    compiled_.samples = wish_.samples;
    compile::setView(camera_, image_, compiled_.frame);
    constants_ = compile::specialise(compiled_, camera_);
    progressive_.show(compiled_, constants_, shader_);
    timing_.pipeline = progressive_.compile_ms();
    timing_.pipelines = progressive_.compilations();
    restart(coarseDivisor());
}

void Rendering::follow(const Wish& wish) {
    const bool isOtherView = wish.cameraNumber != wish_.cameraNumber || wish.samples != wish_.samples;
    const bool isOtherPipeline = (wish.samples > 1) != (wish_.samples > 1);
    wish_ = wish;
    const bool isOtherShader = takeShader();
    if (!isOtherView && !isOtherShader) return;
    camera_ = wish.camera.value_or(scene_->camera);
    image_.samples = wish.samples;
    if (isOtherShader || isOtherPipeline || compile::specialise(compiled_, camera_) != constants_) start();
    else restart(coarseDivisor());
}

device::Frame Rendering::frameOf(std::uint32_t divisor) const {
    scene::Image image = image_;
    image.width = divided(image.width, divisor);
    image.height = divided(image.height, divisor);
    device::Frame frame = compiled_.frame;
    compile::setView(camera_, image, frame);
    return frame;
}

void Rendering::restart(std::uint32_t divisor) {
    divisor_ = divisor;
    progressive_.look(frameOf(divisor));
}

double Rendering::fullPixels() const {
    return 1.0 * image_.width * image_.height;
}

std::uint32_t Rendering::coarseDivisor() const {
    const auto sample_ms = progressive_.expected_ms(static_cast<std::uint64_t>(fullPixels()));
    const double developed = std::max<double>(1.0, static_cast<double>(pixels_.size()));
    const double share = sample_ms ? (*sample_ms + timing_.develop / developed * fullPixels()) / kCoarse_ms
                                   : fullPixels() / kFirstPixels;
    return static_cast<std::uint32_t>(std::clamp(std::ceil(std::sqrt(share)), 1.0, kCoarsest));
}

bool Rendering::isComplete() const {
    if (!isFull()) return wish_.isMoving && progressive_.samples() > 0;
    return progressive_.samples() >= wish_.samples;
}

bool Rendering::advance() {
    if (!isFull() && progressive_.samples() > 0) {
        const auto sample_ms = progressive_.expected_ms(static_cast<std::uint64_t>(fullPixels()));
        restart(sample_ms.value_or(0.0) <= kAtOnce_ms ? 1 : divisor_ / 2);
    }
    const std::uint32_t before = progressive_.samples();
    progressive_.advance(isFull() ? wish_.samples : 1);
    timing_.sample = progressive_.expected_ms(static_cast<std::uint64_t>(fullPixels())).value_or(0.0);
    return progressive_.samples() != before;
}

Picture Rendering::develop() {
    timing_.develop = 0.0;
    const Stopwatch watch(timing_.develop);
    const device::Frame& frame = progressive_.frame();
    Picture picture{.wish = wish_.number,
                    .width = frame.width,
                    .height = frame.height,
                    .samples = progressive_.samples(),
                    .isComplete = isFull() && isComplete(),
                    .exposure = scene_->image.exposure + wish_.display.exposure,
                    .rgba = {},
                    .film = nullptr,
                    .development = {},
                    .timing = timing_,
                    .scene = scene_,
                    .source = source_};
    progressive_.read(pixels_);
    if (wavelength_nm_) spreadOverColors(pixels_);
    if (scene_->image.autoExposure) {
        image::ExposureMeter meter(development_);
        meter.add(pixels_);
        picture.exposure += meter.exposure();
    }
    rgb_.resize(3 * pixels_.size());
    picture.development = development_;
    picture.development.toneCurve = wish_.display.toneCurve;
    picture.development.exposure = picture.exposure;
    image::Development onScreen = picture.development;
    onScreen.colorSpace = image::ColorSpace::srgb;  // that of windows
    const bool isGrey = wish_.display.view == View::greyWavelength;
    if (wavelength_nm_) tint(pixels_, onScreen, isGrey ? glm::dvec3(1.0) : tintOf(*wavelength_nm_), rgb_);
    else if (wish_.display.view == View::decades) falseColors(pixels_, picture.exposure, rgb_);
    else image::develop8(onScreen, pixels_, rgb_);
    if (isFull() && !wavelength_nm_)
        picture.film = std::make_shared<const image::Image>(image::Image{frame.width, frame.height, pixels_});
    picture.rgba.resize(4 * pixels_.size());
    for (std::size_t i = 0; i < pixels_.size(); ++i) std::copy_n(&rgb_[3 * i], 3, &picture.rgba[4 * i]);
    return picture;
}

std::string Rendering::specialisation() const {
    std::string text;
#define APPEND(id, name)                                      \
    if (constants_.name != 0) {                               \
        if (!text.empty()) text += ", ";                      \
        text += fmt::format("{} {}", #name, constants_.name); \
    }
    FRINGE_SPECIALISATION(APPEND)
#undef APPEND
    return text;
}

}  // namespace fringe::preview
