#include "qualify/bench_evaluators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include "qualify/evaluator_judge.hpp"
#include "qualify/evaluator_sums.hpp"
#include "qualify/halves.hpp"

namespace fringe::qualify {
namespace {

using glm::dvec3;
using scene::Evaluator;

constexpr std::uint32_t kMostInputs = 1U << 20;
constexpr double kRounding = 2e-5;  // that the stable sum's arithmetic may cost

std::vector<EvaluatorSetting> settingsOf(const EvaluatorCase& which) {
    std::vector<EvaluatorSetting> settings{{"auto", "", Evaluator::automatic, {}}};
    if (which.isWidelyLit) return settings;  // another beam than that of the far field
    if (!hasContinuum(which)) {
        settings.push_back({"small-angle", "lines", Evaluator::smallAngle, {}});
        settings.push_back({"naive", "lines", Evaluator::naive, {}});
        return settings;
    }
    settings.push_back({"table", "", Evaluator::table, {}});
    for (const std::uint32_t waves : {3U, 8U, 16U, 31U, 81U, 401U})
        settings.push_back({"direct", fmt::format("{} wavelengths", waves), Evaluator::direct, waves});
    settings.push_back({"small-angle", "81 wavelengths", Evaluator::smallAngle, 81U});
    settings.push_back({"naive", "81 wavelengths", Evaluator::naive, 81U});
    if (undeviatedUpTo(which) > 0.0) settings.push_back({"orders", "", Evaluator::orders, {}});
    return settings;
}

std::string detailOf(const EvaluatorCase& which, const EvaluatorSetting& setting,
                     const PreparedSlits& slits) {
    if (setting.kind == Evaluator::table) return fmt::format("{} entries", slits.grating().entries);
    if (setting.kind != Evaluator::automatic) return {};
    if (!hasContinuum(which)) return "lines";
    const char* name = compile::nameOf(slits.choice.evaluator);
    return slits.choice.wavelengths > 0 ? fmt::format("{}, {} wavelengths", name, slits.choice.wavelengths)
                                        : name;
}

// A row that is to be timed: `run(inputs)` returns milliseconds.
struct Timed {
    std::size_t row;
    std::function<double(std::size_t)> run;
    std::size_t inputs = 0;
    std::vector<double> perMillion_ms = {};
};

// So many that a run takes about 60 ms.
std::size_t fittingInputs(const std::function<double(std::size_t)>& run) {
    constexpr std::size_t kFirst = 1U << 10, kStep = 64;
    constexpr double kWanted_ms = 60.0, kTelling_ms = 4.0;
    run(kFirst);  // drivers may compile in the first
    std::size_t inputs = kFirst;
    double time_ms = run(inputs);
    while (time_ms < kTelling_ms && inputs < kMostInputs) {
        inputs *= 4;
        time_ms = run(inputs);
    }
    const double fitting = static_cast<double>(inputs) * kWanted_ms / std::max(time_ms, 1e-3);
    return static_cast<std::size_t>(std::clamp(fitting, 1.0 * kStep, 1.0 * kMostInputs)) / kStep * kStep;
}

class Bench {
public:
    Bench(const gpu::Device& device, const EvaluatorCase& which, const EvaluatorRequest& request,
          const BenchControl& control)
        : device_(device),
          which_(which),
          request_(request),
          control_(control),
          windows_(drawWindows(which, request.seed, kMostInputs)),
          truth_(oracleTruth(which, windows_, request.oraclePatterns, control.cancelled)) {}

    std::vector<EvaluatorRow> rows() {
        verify();
        time();
        return control_.cancelled ? std::vector<EvaluatorRow>() : std::move(rows_);
    }

private:
    bool isAsked(const std::string& evaluator) const {
        const auto& asked = request_.evaluators;
        return !control_.cancelled &&
               (asked.empty() || std::find(asked.begin(), asked.end(), evaluator) != asked.end());
    }

    void verify() {
        for (const EvaluatorSetting& setting : settingsOf(which_))
            if (isAsked(setting.evaluator)) add(setting);
        if (!hasContinuum(which_) || which_.isWidelyLit) return;
        for (const auto& [name, kind] :
             {std::pair("direct", Evaluator::direct), std::pair("naive", Evaluator::naive)})
            if (isAsked(name)) addArithmetic({name, "81 wavelengths, rounding alone", kind, 81U});
        if (isAsked("processor")) addProcessor();
    }

    EvaluatorRow& newRow(const EvaluatorSetting& setting) {
        EvaluatorRow& row = rows_.emplace_back();
        row.caseName = which_.name;
        row.evaluator = setting.evaluator;
        row.setting = setting.name;
        return row;
    }

    void add(const EvaluatorSetting& setting) {
        const PreparedSlits prepared = prepare(which_, setting, request_.tolerance);
        EvaluatorRow& row = newRow(setting);
        row.detail = detailOf(which_, setting, prepared);
        row.tableBytes = prepared.bytes();
        row.buildSeconds = prepared.buildSeconds;
        if (setting.kind == Evaluator::automatic) {
            row.bound = request_.tolerance;
            // One just noticeable difference; who allows a larger error than usual allows colours to differ.
            if (request_.tolerance <= EvaluatorRequest().tolerance) row.deltaEBound = 1.0;
        }
        const auto probe = std::make_shared<EvaluatorProbe>(device_, prepared, windows_);
        probe->run(truth_.values.size());
        judge(
            truth_, windows_, [&](std::size_t i) { return probe->result(i); }, row);
        timed_.push_back({rows_.size() - 1, [probe](std::size_t inputs) { return probe->run(inputs); }});
    }

    // Against the same sum in double precision, at single points: what is left is the device's rounding.
    void addArithmetic(const EvaluatorSetting& setting) {
        const PreparedSlits prepared = prepare(which_, setting, request_.tolerance);
        constexpr std::size_t kJudged = 1U << 14;
        std::vector<EvaluatorWindow> points(windows_.begin(), windows_.begin() + kJudged);
        for (EvaluatorWindow& point : points) point.width = 0.0F;
        const Waves list = wavesOf(prepared);
        std::vector<dvec3> values(kJudged);
        onTwoThreads(kJudged, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i)
                values[i] = sumAt(list, double{points[i].u}, undeviatedUpTo(which_));
        });
        EvaluatorRow& row = newRow(setting);
        if (setting.kind == Evaluator::direct) row.bound = kRounding;
        const EvaluatorProbe probe(device_, prepared, points);
        probe.run(kJudged);
        judge(
            truthOf(std::move(values)), points, [&](std::size_t i) { return probe.result(i); }, row);
    }

    // All orders, the undeviated one too, at single points: it is here for its time. It is judged where
    // nothing is left out; its error is that of points beside windows.
    void addProcessor() {
        const EvaluatorSetting setting{"processor", "81 wavelengths, 2 threads", Evaluator::direct, 81U};
        const CpuWaves waves = forProcessor(wavesOf(prepare(which_, setting, request_.tolerance)));
        const auto xyz = std::make_shared<std::vector<float>>(3 * windows_.size());
        std::vector<float> u;
        for (const EvaluatorWindow& window : windows_) u.push_back(window.u);
        const auto run = [waves, u = std::move(u), xyz](std::size_t inputs) {
            const auto start = std::chrono::steady_clock::now();
            onTwoThreads(inputs, [&](std::size_t from, std::size_t to) {
                cpuSum(waves, std::span(u).subspan(from, to - from),
                       std::span(*xyz).subspan(3 * from, 3 * (to - from)));
            });
            return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count();
        };
        EvaluatorRow& row = newRow(setting);
        if (undeviatedUpTo(which_) == 0.0) {
            run(truth_.values.size());
            judge(
                truth_, windows_,
                [&](std::size_t i) {
                    return std::pair(dvec3((*xyz)[3 * i], (*xyz)[3 * i + 1], (*xyz)[3 * i + 2]), true);
                },
                row);
        }
        timed_.push_back({rows_.size() - 1, run});
    }

    void time() {
        if (control_.rounds == 0) return;
        for (int round = 0; round < control_.rounds; ++round) {
            for (Timed& timed : timed_) {
                if (control_.cancelled) return;
                if (round == 0) timed.inputs = fittingInputs(timed.run);
                timed.perMillion_ms.push_back(timed.run(timed.inputs) * 1e6 /
                                              static_cast<double>(timed.inputs));
            }
            control_.onProgress((round + 1.0) / control_.rounds);
        }
        for (const Timed& timed : timed_) {
            rows_[timed.row].perMillion_ms = spreadOf(timed.perMillion_ms);
            rows_[timed.row].ratio = ratioOf(timed.perMillion_ms, timed_.front().perMillion_ms);
        }
    }

    const gpu::Device& device_;
    const EvaluatorCase& which_;
    const EvaluatorRequest& request_;
    const BenchControl& control_;
    std::vector<EvaluatorWindow> windows_;
    EvaluatorTruth truth_;
    std::vector<EvaluatorRow> rows_;
    std::vector<Timed> timed_;
};

}  // namespace

std::vector<EvaluatorRow> benchEvaluators(const gpu::Device& device, const EvaluatorCase& which,
                                          const EvaluatorRequest& request, const BenchControl& control) {
    return Bench(device, which, request, control).rows();
}

}  // namespace fringe::qualify
