// Work on two threads: what the processor's sums are timed with, on machines of any size.
#pragma once

#include <cstddef>
#include <thread>
#include <vector>

namespace fringe::qualify {

// work(from, to) for either half of 0 .. count.
template <class Work>
void onTwoThreads(std::size_t count, const Work& work) {
    constexpr unsigned kThreads = 2;
    std::vector<std::jthread> workers;
    for (unsigned thread = 0; thread < kThreads; ++thread)
        workers.emplace_back(
            [&, thread] { work(count * thread / kThreads, count * (thread + 1) / kThreads); });
}

}  // namespace fringe::qualify
