// Ctrl-C and SIGTERM as a flag that the renderers poll; a second signal ends the program at once.
#pragma once

#include <atomic>

namespace fringe::cli {

// From now on the signals set the flag.
void catchInterrupts();

const std::atomic<bool>& interrupted();

// 130 after SIGINT, 143 after SIGTERM.
int interruptStatus();

}  // namespace fringe::cli
