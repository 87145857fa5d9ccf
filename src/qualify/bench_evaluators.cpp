#include "qualify/bench_evaluators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>
#include <thread>

#include "compile/compiled_scene.hpp"
#include "compile/evaluators.hpp"
#include "compile/gratings.hpp"
#include "compile/slit_response.hpp"
#include "gpu/constant_block.hpp"
#include "gpu/kernel.hpp"
#include "gpu/texels.hpp"
#include "optics/color_difference.hpp"
#include "optics/sources.hpp"
#include "oracle/exact_pattern.hpp"
#include "oracle/slit_color.hpp"
#include "qualify/cpu_sum.hpp"
#include "qualify/draw.hpp"
#include "shaders/bench_evaluators.comp.h"

namespace fringe::qualify {
namespace {

using Clock = std::chrono::steady_clock;
using glm::dvec3;
using scene::Evaluator;
using units::um;

constexpr double kWindow = 2e-4;
constexpr std::uint32_t kGroup = 64;
constexpr std::uint32_t kMostInputs = 1U << 20;
constexpr double kDispatch_ms = 60.0;
constexpr unsigned kThreads = 2;

struct Window {
    float u;
    float width;
};

struct Result {
    float x, y, z;
    float wasNonFinite;
};

double seconds(Clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

bool hasContinuum(const EvaluatorCase& which) {
    return !which.spectrum.density.empty();
}

// ---- a grating as the device has it --------------------------------------------------------------

struct Setting {
    std::string evaluator;
    std::string name;
    Evaluator kind;
    std::optional<std::uint32_t> wavelengths;
};

// Across the slits is -x.
scene::Grating gratingOf(const EvaluatorCase& which, const Setting& setting) {
    const optics::Slits slits{which.count, which.width_um * um, which.period_um * um};
    return {.position = {0, 0, 0},
            .normal = {0, 0, -1},
            .slitDirection = {0, 1, 0},
            .aperture = slits,
            .beam = {.profile = scene::BeamProfile::rectangle,
                     .width = 1.0 * which.count * slits.period,  // no wider: as seen from the far field
                     .height = 1.0 * units::m,
                     .direction = {-which.incoming, 0, -std::sqrt(1.0 - which.incoming * which.incoming)},
                     .power = 1.0 * units::W,
                     .angularSize = {},
                     .focus = {}},
            .efficiency = 1.0,
            .efficiencies = {},
            .evaluator = setting.kind,
            .wavelengths = setting.wavelengths};
}

struct Prepared {
    compile::CompiledScene scene;
    compile::EvaluatorChoice choice;
    double buildSeconds = 0.0;

    const device::SlitGrating& grating() const { return scene.slitGratings.front(); }
};

Prepared prepare(const EvaluatorCase& which, const Setting& setting, double tolerance) {
    const scene::Grating grating = gratingOf(which, setting);
    const auto& slits = std::get<optics::Slits>(grating.aperture);
    const compile::SpectralTables tables(compile::Measure::color, 1);
    Prepared made;
    const Clock::time_point start = Clock::now();
    std::vector<compile::KnownSlits> known;
    made.scene.slitGratings.push_back(compile::compileSlits(grating, slits, which.spectrum, tables, tolerance,
                                                            made.scene.tables, made.scene.responses, known));
    made.buildSeconds = seconds(Clock::now() - start);
    made.scene.frame.reflectanceCount = 1;
    made.choice = compile::chooseEvaluator(grating, slits, which.spectrum, {}, tolerance);
    return made;
}

std::span<const std::byte> bytesOf(const std::vector<device::ResponseEntry>& entries) {
    return std::as_bytes(std::span(entries));
}

// As `fringe render` has it.
gpu::TexelHome homeOf(const gpu::Device& device, const std::vector<device::ResponseEntry>& entries) {
    return gpu::fitTexelBuffer(device, bytesOf(entries).size()) ? gpu::TexelHome::buffer
                                                                : gpu::TexelHome::image;
}

class OnDevice {
public:
    OnDevice(const gpu::Device& device, const Prepared& prepared, std::span<const Window> windows)
        : device_(device),
          tables_(device, std::max<std::size_t>(prepared.scene.tables.size() * sizeof(float), 16),
                  gpu::Access::hostWrites),
          responses_(device, "response tables", bytesOf(prepared.scene.responses),
                     homeOf(device, prepared.scene.responses), device::TEXEL_ROW),
          inputs_(device, windows.size_bytes(), gpu::Access::hostWrites),
          results_(device, windows.size() * sizeof(Result), gpu::Access::hostReads),
          kernel_(makeKernel(prepared)) {
        std::memcpy(tables_.mapped().data(), prepared.scene.tables.data(),
                    prepared.scene.tables.size() * sizeof(float));
        std::memcpy(inputs_.mapped().data(), windows.data(), windows.size_bytes());
    }

    // Returns how long the host waited, in milliseconds.
    double run(std::size_t inputs) const {
        const gpu::Groups origin{0, 0, 0};
        const Clock::time_point start = Clock::now();
        kernel_.run({&origin, 1}, {static_cast<std::uint32_t>((inputs + kGroup - 1) / kGroup), 1, 1});
        return 1e3 * seconds(Clock::now() - start);
    }

    std::span<const Result> results() const {
        return {reinterpret_cast<const Result*>(results_.mapped().data()), results_.size() / sizeof(Result)};
    }

private:
    gpu::Kernel makeKernel(const Prepared& prepared) const {
        // As `fringe render` has it: the scene's values are constants of the shader.
        const device::SceneBlock block = compile::sceneBlock(prepared.scene);
        const std::vector<std::uint32_t> shader =
            gpu::withConstantBlock(bench_evaluators_comp, std::as_bytes(std::span(&block, 1)));
        const scene::Camera camera{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, scene::Orthographic{1.0}, {}};
        device::Specialisation specialisation = compile::specialise(prepared.scene, camera);
        if (homeOf(device_, prepared.scene.responses) == gpu::TexelHome::image)
            specialisation.TEXELS_IN_IMAGES = 1;
        std::array<std::uint32_t, device::kSpecialisationCount> constants{};
        std::memcpy(constants.data(), &specialisation, sizeof specialisation);

        // Numbers of bindings.glsl and of bench_evaluators.comp.
        constexpr std::size_t kResponses = 17, kResponseImage = 18, kInputs = 19, kResults = 20;
        const auto storage = vk::DescriptorType::eStorageBuffer;
        // Arrays that are never read are some buffer.
        std::vector<gpu::Binding> bindings(kResults + 1,
                                           gpu::Binding{storage, tables_.handle(), 0, tables_.size()});
        bindings[kResponses] = responses_.buffer();
        bindings[kResponseImage] = responses_.image();
        bindings[kInputs] = {storage, inputs_.handle(), 0, inputs_.size()};
        bindings[kResults] = {storage, results_.handle(), 0, results_.size()};
        return {device_, shader, bindings, constants};
    }

    const gpu::Device& device_;
    gpu::Buffer tables_;
    gpu::Texels responses_;
    gpu::Buffer inputs_;
    gpu::Buffer results_;
    gpu::Kernel kernel_;  // needs all of them
};

// ---- inputs --------------------------------------------------------------------------------------

// Where the undeviated light is left to the beam's own pattern, seen up to here (shaders/slits.glsl).
double lastLobe(const EvaluatorCase& which, bool isWide) {
    const double extent_um = (which.count - 1.0) * which.period_um + which.width_um;
    return isWide ? double{device::ZERO_ORDER_LOBES} * double{device::LAST_WAVE_um} / extent_um : 0.0;
}

// Small angles and large ones, orders and their side lobes, 0 itself. What lies where the undeviated light
// changes hands belongs to neither side.
std::vector<Window> draw(const EvaluatorCase& which, bool isWide, std::uint64_t seed, std::size_t count) {
    // Where Z, Y and X of daylight are largest in the first order: errors are shares of the brightest place.
    constexpr std::array kBrightest_um{0.45, 0.555, 0.6};
    const double border = lastLobe(which, isWide);
    const double clear = 2.0 * kWindow + 2.0 / std::max(64.0, 450.0 * which.period_um);
    std::vector<Window> windows;
    for (std::uint64_t number = 0; windows.size() < count; ++number) {
        Draw draw(seed, number);
        const double low = -which.largestSine - which.incoming, high = which.largestSine - which.incoming;
        double u = draw.between(low, high);
        if (number == 0) {
            u = 0.0;
        } else if (number <= kBrightest_um.size()) {
            u = std::copysign(kBrightest_um[number - 1] / which.period_um, -which.incoming);
        } else if (draw.oneIn(4)) {
            u = draw.sign() * draw.magnitude(1e-6, which.largestSine);
        } else if (draw.oneIn(4)) {
            // Of a line, or of one of 81 wavelengths.
            const auto& lines = which.spectrum.lines;
            const double wavelength_um =
                lines.empty() ? 0.38 + 0.005 * draw.below(81)
                              : lines[draw.below(static_cast<std::uint32_t>(lines.size()))].wavelength / um;
            const double order = std::nearbyint(u * which.period_um / wavelength_um);
            const double beside = draw.oneIn(3) ? 0.0 : draw.between(-3.0, 3.0) / which.count;
            u = (order + beside) * wavelength_um / which.period_um;
        }
        if (u < low || u > high || (isWide && std::abs(std::abs(u) - border) < clear)) continue;
        windows.push_back({static_cast<float>(u), static_cast<float>(kWindow)});
    }
    return windows;
}

template <class Work>
void onThreads(std::size_t count, const Work& work) {
    std::vector<std::jthread> workers;
    for (unsigned thread = 0; thread < kThreads; ++thread)
        workers.emplace_back(
            [&, thread] { work(count * thread / kThreads, count * (thread + 1) / kThreads); });
}

// ---- judgement -----------------------------------------------------------------------------------

double largest(const dvec3& value) {
    return std::max({std::abs(value.x), std::abs(value.y), std::abs(value.z)});
}

struct Truth {
    std::vector<dvec3> values;
    double peak = 0.0;  // the largest of X, Y and Z
    dvec3 white{1.0};   // D65 of the largest Y
};

Truth truthOf(std::vector<dvec3> values) {
    Truth truth{std::move(values)};
    double brightest = 0.0;
    for (const dvec3& value : truth.values) {
        truth.peak = std::max(truth.peak, largest(value));
        brightest = std::max(brightest, value.y);
    }
    const dvec3 d65(0.95047, 1.0, 1.08883);
    truth.white = brightest * d65;
    return truth;
}

// `got(i)`: the i-th result, and whether it is a number.
template <class Got>
void judge(const Truth& truth, std::span<const Window> windows, const Got& got, BenchRow& row) {
    double squares = 0.0, difference = 0.0;
    std::size_t finite = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        const auto [value, isFinite] = got(i);
        if (!isFinite || !std::isfinite(value.x + value.y + value.z)) {
            ++row.nonFinite;
            continue;
        }
        ++finite;
        const double error = largest(value - truth.values[i]) / truth.peak;
        if (error > row.maxError) {
            row.maxError = error;
            row.worstInput = double{windows[i].u};
        }
        squares += error * error;
        difference =
            std::max(difference, optics::colorDifference(optics::labFromXyz(value, truth.white),
                                                         optics::labFromXyz(truth.values[i], truth.white)));
    }
    row.rmsError = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(finite, 1)));
    row.deltaE = difference;
}

auto resultsOf(std::span<const Result> results) {
    return [results](std::size_t i) {
        const Result& r = results[i];
        return std::pair(dvec3(r.x, r.y, r.z), r.wasNonFinite == 0.0F);
    };
}

// ---- time ----------------------------------------------------------------------------------------

// `run(inputs)` returns milliseconds. In dispatches of about kDispatch_ms.
template <class Run>
void timed(int repetitions, const Run& run, BenchRow& row) {
    if (repetitions == 0) return;
    constexpr std::size_t kFirst = 1U << 14;
    run(kFirst);  // drivers may compile in the first
    const double first_ms = run(kFirst);
    const double fitting = kFirst * kDispatch_ms / std::max(first_ms, 1e-3);
    const auto inputs =
        static_cast<std::size_t>(std::clamp(fitting, 1.0 * kGroup, 1.0 * kMostInputs)) / kGroup * kGroup;
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) times.push_back(run(inputs) * 1e6 / static_cast<double>(inputs));
    std::sort(times.begin(), times.end());
    row.perMillion_ms = times[times.size() / 2];
    row.spread_ms = 0.5 * (times[times.size() * 3 / 4] - times[times.size() / 4]);
}

// ---- sums by the host ----------------------------------------------------------------------------

// The list of waves that the device has, in double precision.
struct Waves {
    struct Wave {
        float periodHigh, periodLow, width;
        dvec3 color;
    };
    double count;
    std::vector<Wave> waves;
};

Waves wavesOf(const Prepared& prepared) {
    const device::SlitGrating& g = prepared.grating();
    const auto real = [](device::uint bits) { return std::bit_cast<float>(bits); };
    Waves list{g.count, {}};
    for (device::uint i = 0; i < g.entries; ++i) {
        const device::ResponseEntry& wave = prepared.scene.responses[g.response + i];
        const device::ResponseEntry& color = prepared.scene.responses[g.response + g.entries + i];
        list.waves.push_back({real(wave.integral.x), real(wave.integral.y), real(wave.integral.z),
                              dvec3(real(color.integral.x), real(color.integral.y), real(color.integral.z))});
    }
    return list;
}

// The same sum, with what is left out of it, at a single u.
dvec3 sumAt(const Waves& list, double u, double undeviatedUpTo) {
    dvec3 sum(0.0);
    for (const Waves::Wave& wave : list.waves) {
        const double past = oracle::turnsPast(u, wave.periodHigh, wave.periodLow);
        double value = oracle::slitPattern(u * wave.width) * oracle::arrayPattern(past, list.count);
        if (std::abs(u) <= undeviatedUpTo) {
            value -= oracle::slitPattern(u * wave.width) *
                     oracle::slitPattern(list.count * u * (double{wave.periodHigh} + wave.periodLow));
        }
        sum += value * wave.color;
    }
    return sum;
}

CpuWaves forProcessor(const Waves& list) {
    CpuWaves waves{static_cast<float>(list.count), {}, {}, {}, {}, {}};
    for (const Waves::Wave& wave : list.waves) {
        waves.period.push_back(wave.periodHigh);
        waves.width.push_back(wave.width);
        waves.x.push_back(static_cast<float>(wave.color.x));
        waves.y.push_back(static_cast<float>(wave.color.y));
        waves.z.push_back(static_cast<float>(wave.color.z));
    }
    return waves;
}

// ---- rows ----------------------------------------------------------------------------------------

std::vector<Setting> settingsOf(const EvaluatorCase& which, bool isWide) {
    if (!hasContinuum(which)) {
        return {{"auto", "", Evaluator::automatic, {}},
                {"small-angle", "lines", Evaluator::smallAngle, {}},
                {"naive", "lines", Evaluator::naive, {}}};
    }
    std::vector<Setting> settings{{"auto", "", Evaluator::automatic, {}},
                                  {"table", "", Evaluator::table, {}}};
    for (const std::uint32_t waves : {8U, 16U, 31U, 81U, 401U})
        settings.push_back({"direct", fmt::format("{} wavelengths", waves), Evaluator::direct, waves});
    settings.push_back({"small-angle", "81 wavelengths", Evaluator::smallAngle, 81U});
    settings.push_back({"naive", "81 wavelengths", Evaluator::naive, 81U});
    if (isWide) settings.push_back({"orders", "", Evaluator::orders, {}});
    return settings;
}

class Bench {
public:
    Bench(const gpu::Device& device, const EvaluatorCase& which, const EvaluatorRequest& request)
        : device_(device),
          which_(which),
          request_(request),
          isWide_(hasContinuum(which) &&
                  compile::areWide({which.count, which.width_um * um, which.period_um * um})),
          windows_(draw(which, isWide_, request.seed, kMostInputs)),
          truth_(truth()) {}

    std::vector<BenchRow> rows() {
        for (const Setting& setting : settingsOf(which_, isWide_))
            if (isAsked(setting.evaluator)) add(setting);
        if (hasContinuum(which_)) {
            for (const auto& [name, kind] :
                 {std::pair("direct", Evaluator::direct), std::pair("naive", Evaluator::naive)})
                if (isAsked(name)) addArithmetic({name, "81 wavelengths, rounding alone", kind, 81U});
            if (isAsked("processor")) addProcessor();
        }
        return std::move(rows_);
    }

private:
    bool isAsked(const std::string& evaluator) const {
        const auto& asked = request_.evaluators;
        return asked.empty() || std::find(asked.begin(), asked.end(), evaluator) != asked.end();
    }

    Truth truth() const {
        const compile::LitSlits lit{
            {which_.count, which_.width_um * um, which_.period_um * um}, {}, which_.incoming, 0.0};
        // Tenths of a nanometre: it jumps where an order passes off.
        constexpr double kPerNanometre = 10.0;
        std::array<double, 4001> shares{};
        onThreads(shares.size(), [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                shares[i] = lit.propagatingShare(oracle::kFirst_nm + static_cast<double>(i) / kPerNanometre);
        });
        const auto shareAt = [&](double wavelength_nm) {
            return shares.at(
                static_cast<std::size_t>(std::lround(kPerNanometre * (wavelength_nm - oracle::kFirst_nm))));
        };
        const oracle::SlitColor color({1.0 * which_.count, which_.width_um, which_.period_um, which_.spectrum,
                                       shareAt, lastLobe(which_, isWide_)});
        const double perInput = std::max(1600.0, 0.85 * which_.count * which_.period_um *
                                                     (which_.largestSine + std::abs(which_.incoming))) *
                                (kWindow * which_.period_um < 6e-4 ? 1.0 : 12.0);
        const auto judged =
            static_cast<std::size_t>(std::clamp(request_.oraclePatterns / perInput, 48.0, 2048.0));
        std::vector<dvec3> values(judged);
        onThreads(judged, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                values[i] = color.mean(double{windows_[i].u}, double{windows_[i].width});
        });
        return truthOf(std::move(values));
    }

    void add(const Setting& setting) {
        const Prepared prepared = prepare(which_, setting, request_.tolerance);
        BenchRow row;
        row.caseName = which_.name;
        row.evaluator = setting.evaluator;
        row.setting = setting.name;
        if (setting.kind == Evaluator::automatic) {
            row.setting = !hasContinuum(which_) ? "lines"
                          : prepared.choice.wavelengths > 0
                              ? fmt::format("{}, {} wavelengths", compile::nameOf(prepared.choice.evaluator),
                                            prepared.choice.wavelengths)
                              : compile::nameOf(prepared.choice.evaluator);
        } else if (setting.kind == Evaluator::table) {
            row.setting = fmt::format("{} entries", prepared.grating().entries);
        }
        row.tableBytes = prepared.scene.responses.size() * sizeof(device::ResponseEntry) +
                         prepared.scene.tables.size() * sizeof(float);
        row.buildSeconds = prepared.buildSeconds;
        const OnDevice onDevice(device_, prepared, windows_);
        onDevice.run(truth_.values.size());
        judge(truth_, windows_, resultsOf(onDevice.results()), row);
        timed(
            request_.repetitions, [&](std::size_t inputs) { return onDevice.run(inputs); }, row);
        finish(std::move(row));
    }

    // Against the same sum in double precision, at single points: what is left is the device's rounding.
    void addArithmetic(const Setting& setting) {
        const Prepared prepared = prepare(which_, setting, request_.tolerance);
        constexpr std::size_t kJudged = 1U << 14;
        std::vector<Window> points(windows_.begin(), windows_.begin() + kJudged);
        for (Window& point : points) point.width = 0.0F;
        const Waves list = wavesOf(prepared);
        const float lobe = isWide_ ? device::ZERO_ORDER_LOBES * device::LAST_WAVE_um /
                                         ((prepared.grating().count - 1.0F) * prepared.grating().period_um +
                                          prepared.grating().width_um)
                                   : -1.0F;
        std::vector<dvec3> values(kJudged);
        onThreads(kJudged, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) values[i] = sumAt(list, double{points[i].u}, lobe);
        });
        BenchRow row;
        row.caseName = which_.name;
        row.evaluator = setting.evaluator;
        row.setting = setting.name;
        const OnDevice onDevice(device_, prepared, points);
        onDevice.run(kJudged);
        judge(truthOf(std::move(values)), points, resultsOf(onDevice.results()), row);
        finish(std::move(row));
    }

    // All orders, the undeviated one too, at single points: it is here for its time. So its error is that of
    // points beside windows, and shown where nothing is left out.
    void addProcessor() {
        const Setting setting{"processor", "81 wavelengths, 2 threads", Evaluator::direct, 81U};
        const CpuWaves waves = forProcessor(wavesOf(prepare(which_, setting, request_.tolerance)));
        std::vector<float> u;
        for (const Window& window : windows_) u.push_back(window.u);
        std::vector<float> xyz(3 * u.size());
        const auto run = [&](std::size_t inputs) {
            const Clock::time_point start = Clock::now();
            onThreads(inputs, [&](std::size_t from, std::size_t to) {
                cpuSum(waves, std::span(u).subspan(from, to - from),
                       std::span(xyz).subspan(3 * from, 3 * (to - from)));
            });
            return 1e3 * seconds(Clock::now() - start);
        };
        BenchRow row;
        row.caseName = which_.name;
        row.evaluator = setting.evaluator;
        row.setting = setting.name;
        run(truth_.values.size());
        judge(
            truth_, windows_,
            [&](std::size_t i) { return std::pair(dvec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]), true); },
            row);
        timed(request_.repetitions, run, row);
        finish(std::move(row));
    }

    void finish(BenchRow row) {
        request_.onRow(row);
        rows_.push_back(std::move(row));
    }

    const gpu::Device& device_;
    const EvaluatorCase& which_;
    const EvaluatorRequest& request_;
    bool isWide_;
    std::vector<Window> windows_;
    Truth truth_;
    std::vector<BenchRow> rows_;
};

}  // namespace

std::span<const EvaluatorCase> evaluatorCases() {
    static const std::vector<EvaluatorCase> cases = [] {
        const optics::Spectrum d65 = *optics::namedSpectrum("D65"), diode = *optics::namedSpectrum("LED-B3"),
                               sodium = *optics::namedSpectrum("sodium"),
                               laser = optics::laser(632.8 * units::nm, {});
        return std::vector<EvaluatorCase>{
            {"1 slit of 1 um, D65", 1, 1.0, 1.0, d65, 0.95},
            {"1 slit of 20 um, D65", 1, 20.0, 20.0, d65, 0.95},
            {"2 slits of 1/2 um, D65", 2, 1.0, 2.0, d65, 0.95},
            {"5 slits of 1/2 um, D65", 5, 1.0, 2.0, d65, 0.95},
            {"5 slits of 1/2 um, D65, to 3 deg", 5, 1.0, 2.0, d65, 0.052},
            {"5 slits of 20/100 um, D65", 5, 20.0, 100.0, d65, 0.95},
            {"50 slits of 0.8/1.6 um, D65", 50, 0.8, 1.6, d65, 0.95},
            {"50 slits of 50/100 um, D65", 50, 50.0, 100.0, d65, 0.95},
            {"1000 slits of 0.8/1.6 um, D65", 1000, 0.8, 1.6, d65, 0.95},
            {"1000 slits of 50/100 um, D65", 1000, 50.0, 100.0, d65, 0.95},
            {"10^4 slits of 0.8/1.6 um, D65", 10'000, 0.8, 1.6, d65, 0.95},
            {"10^6 slits of 0.16/0.32 um at 58 deg, D65", 1'000'000, 0.16, 0.32, d65, 0.95, 0.85},
            {"10^6 slits of 0.8/1.6 um, D65", 1'000'000, 0.8, 1.6, d65, 0.95},
            {"5 slits of 1/2 um, white diode", 5, 1.0, 2.0, diode, 0.95},
            {"1000 slits of 0.8/1.6 um, white diode", 1000, 0.8, 1.6, diode, 0.95},
            {"5 slits of 1/2 um, laser", 5, 1.0, 2.0, laser, 0.95},
            {"1000 slits of 0.8/1.6 um, laser", 1000, 0.8, 1.6, laser, 0.95},
            {"5 slits of 1/2 um, sodium", 5, 1.0, 2.0, sodium, 0.95},
            {"1000 slits of 0.8/1.6 um, sodium", 1000, 0.8, 1.6, sodium, 0.95},
        };
    }();
    return cases;
}

std::vector<BenchRow> benchEvaluators(const gpu::Device& device, const EvaluatorCase& which,
                                      const EvaluatorRequest& request) {
    return Bench(device, which, request).rows();
}

}  // namespace fringe::qualify
