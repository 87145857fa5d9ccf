#include "preview/measuring.hpp"

#include "profile/sampling.hpp"
#include "render/stopwatch.hpp"

namespace fringe::preview {

void Measuring::begin(const Probe& probe, const std::shared_ptr<const scene::Scene>& scene,
                      std::uint32_t samplesOfScene, const std::string& file) {
    if (isUnderWay_ && probe.number == number_ && scene == scene_) return;
    number_ = probe.number;
    scene_ = scene;
    isDone_ = isUnderWay_ = false;
    begin_ms_ = 0.0;
    const render::Stopwatch watch(begin_ms_);
    const profile::SurfaceLine line = profile::surfaceUnder(*scene, probe.from, probe.to, probe.eye);
    scene::Scene row = profile::lineScene(*scene, line, probe.samples);
    row.image.samples = samples_ = samplesOfScene;
    const std::vector<const scene::Light*> gratings = profile::spectrometersOf(*scene);
    const scene::Light* grating = gratings.size() == 1 ? gratings.front() : nullptr;
    report_ =
        std::make_shared<profile::Report>(profile::reportOn(*scene, file, line, grating, probe.samples));
    const compile::CompiledScene compiled = compile::compileScene(row, compile::Measure::spectrum);
    progressive_.show(compiled, compile::specialise(compiled, row.camera));
    isUnderWay_ = true;
}

double Measuring::advance() {
    progressive_.advance(samples_);
    return progressive_.progress() / samples_;
}

Measured Measuring::take() {
    std::vector<image::Pixel> pixels;
    progressive_.read(pixels);
    profile::takePicture(pixels, *report_);
    isDone_ = true;
    isUnderWay_ = false;
    return {number_, scene_, std::move(report_), {}};
}

}  // namespace fringe::preview
