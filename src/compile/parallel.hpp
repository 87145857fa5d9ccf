// Work that falls into equal parts, on all processors.
#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace fringe::compile {

// work(i) for i = 0 .. count - 1. Threads take turns, because the first parts may be quicker.
template <class Work>
void inParallel(int count, Work work) {
    const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::jthread> helpers;
    const auto share = [&](int thread) {
        for (int i = thread; i < count; i += threads) work(i);
    };
    for (int thread = 1; thread < threads; ++thread) helpers.emplace_back(share, thread);
    share(0);
}

}  // namespace fringe::compile
