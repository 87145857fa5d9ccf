#include "qualify/stress.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include "gpu/kernel.hpp"
#include "qualify/error_spread.hpp"

namespace fringe::qualify {
namespace {

// Evaluations of one dispatch: a fraction of a second of the slowest, 16 MiB of inputs of the widest.
constexpr std::uint64_t kBatch = std::uint64_t{1} << 17;
constexpr std::uint64_t kProbeGroup = 64;  // local_size_x of the probes

// work(thread, first, end) for shares of 0..count-1.
template <class Work>
void inParallel(unsigned threads, std::uint64_t count, Work work) {
    const std::uint64_t share = (count + threads - 1) / threads;
    std::vector<std::jthread> helpers;
    for (unsigned i = 1; i < threads; ++i)
        helpers.emplace_back(
            [&, i] { work(i, std::min(i * share, count), std::min((i + 1) * share, count)); });
    work(0U, std::uint64_t{0}, std::min(share, count));
}

// What one thread has seen.
struct Tally {
    ErrorSpread errors;
    ErrorSpread ulps;
    std::uint64_t nonFinite = 0;
    std::optional<Witness> worst;
    std::optional<Witness> firstNonFinite;
};

Witness witness(std::uint64_t number, std::span<const float> inputs, std::span<const float> results,
                const Judgement& judgement) {
    return {number, {inputs.begin(), inputs.end()}, {results.begin(), results.end()}, judgement};
}

void judge(const StressCase& stressCase, std::uint64_t number, std::span<const float> inputs,
           std::span<const float> results, Tally& tally) {
    if (!std::all_of(results.begin(), results.end(), [](float value) { return std::isfinite(value); })) {
        ++tally.nonFinite;
        if (!tally.firstNonFinite) tally.firstNonFinite = witness(number, inputs, results, {});
        return;
    }
    const Judgement judgement = stressCase.judge(inputs, results);
    tally.errors.add(judgement.error);
    tally.ulps.add(judgement.ulps);
    if (!tally.worst || judgement.error > tally.worst->judgement.error)
        tally.worst = witness(number, inputs, results, judgement);
}

bool isWorse(const Witness& a, const Witness& b) {
    if (a.judgement.error != b.judgement.error) return a.judgement.error > b.judgement.error;
    return a.number < b.number;
}

StressReport summary(const std::vector<Tally>& tallies) {
    StressReport report;
    ErrorSpread errors, ulps;
    for (const Tally& tally : tallies) {
        errors.add(tally.errors);
        ulps.add(tally.ulps);
        report.nonFinite += tally.nonFinite;
        if (tally.worst && (!report.worst || isWorse(*tally.worst, *report.worst)))
            report.worst = tally.worst;
        if (tally.firstNonFinite &&
            (!report.firstNonFinite || tally.firstNonFinite->number < report.firstNonFinite->number))
            report.firstNonFinite = tally.firstNonFinite;
    }
    constexpr double kMost = 0.999;
    report.count = errors.count() + report.nonFinite;
    report.largest = errors.largest();
    report.most = errors.percentile(kMost);
    report.largestUlps = ulps.largest();
    report.mostUlps = ulps.percentile(kMost);
    return report;
}

}  // namespace

StressReport stress(const gpu::Device& device, const StressCase& stressCase, const StressRequest& request) {
    const auto start = std::chrono::steady_clock::now();
    const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t width = stressCase.inputs.size(), resultWidth = stressCase.results;
    const std::uint64_t batch =
        std::min(kBatch, (request.count + kProbeGroup - 1) / kProbeGroup * kProbeGroup);

    // Drawn here and copied: what the device maps may be slow to read.
    std::vector<float> inputs(batch * width);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(inputs));
    const gpu::Buffer given(device, bytes.size(), gpu::Access::hostWrites);
    const gpu::Buffer results(device, batch * resultWidth * sizeof(float), gpu::Access::hostReads);
    const auto storage = vk::DescriptorType::eStorageBuffer;
    const gpu::Kernel kernel(device, stressCase.shader,
                             std::array{gpu::Binding{storage, given.handle(), 0, given.size()},
                                        gpu::Binding{storage, results.handle(), 0, results.size()}},
                             std::array{stressCase.variant, static_cast<std::uint32_t>(width),
                                        static_cast<std::uint32_t>(resultWidth)});
    const auto* const found = reinterpret_cast<const float*>(results.mapped().data());

    std::vector<Tally> tallies(threads);
    for (std::uint64_t first = 0; first < request.count; first += batch) {
        inParallel(threads, batch, [&](unsigned, std::uint64_t from, std::uint64_t to) {
            for (std::uint64_t i = from; i < to; ++i) {
                Draw draw(request.seed, first + i);
                stressCase.draw(draw, std::span(inputs).subspan(i * width, width));
            }
        });
        std::memcpy(given.mapped().data(), bytes.data(), bytes.size());
        const gpu::Groups origin{0, 0, 0};
        kernel.run({&origin, 1}, {static_cast<std::uint32_t>(batch / kProbeGroup), 1, 1});
        inParallel(threads, std::min(batch, request.count - first),
                   [&](unsigned thread, std::uint64_t from, std::uint64_t to) {
                       for (std::uint64_t i = from; i < to; ++i)
                           judge(stressCase, first + i, std::span(inputs).subspan(i * width, width),
                                 {found + i * resultWidth, resultWidth}, tallies[thread]);
                   });
    }
    StressReport report = summary(tallies);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return report;
}

}  // namespace fringe::qualify
