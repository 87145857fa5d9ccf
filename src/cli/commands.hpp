// The sub-commands. Each adds itself to the command line and, when chosen, runs and gives the exit status:
// 0 done, 1 the scene or an option is wrong, 2 the machine cannot, 3 a check failed. What they throw, main
// catches.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>

namespace fringe::cli {

using Command = std::function<int()>;

// The window cannot be had; the message says what to do.
class NoWindow : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Each sets `chosen` when its sub-command is on the command line.
void addRender(CLI::App& app, Command& chosen);
void addPreview(CLI::App& app, Command& chosen);
void addValidate(CLI::App& app, Command& chosen);
void addInfo(CLI::App& app, Command& chosen);
void addDevices(CLI::App& app, Command& chosen);
void addProfile(CLI::App& app, Command& chosen);
void addCompare(CLI::App& app, Command& chosen);
void addStress(CLI::App& app, Command& chosen);
void addBench(CLI::App& app, Command& chosen);

inline constexpr int kDone = 0;
inline constexpr int kWrongInput = 1;
inline constexpr int kMachineCannot = 2;
inline constexpr int kCheckFailed = 3;

}  // namespace fringe::cli
