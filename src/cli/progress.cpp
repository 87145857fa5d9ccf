#include "cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace fringe::cli {
namespace {

using namespace std::chrono_literals;
constexpr auto kFirst = 1s;  // shorter renders need no progress
constexpr auto kBetween = 100ms;

std::string inMinutes(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(bool quiet) : enabled_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(double done) {
    const auto now = Clock::now();
    if (!enabled_ || now - start_ < kFirst || now - lastShown_ < kBetween || done <= 0.0) return;
    lastShown_ = now;
    shown_ = true;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, "\r\x1b[K{:3.0f} %  {} left", std::floor(100.0 * done),
               inMinutes(elapsed * (1.0 - done) / done));
    std::fflush(stderr);
}

}  // namespace fringe::cli
