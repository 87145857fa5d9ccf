// Runs the real program as a user would: its own process, with the streams, the exit status and the signals
// that a shell or a terminal gives it. Every run has FRINGE_VALIDATION=1, so whatever the Khronos validation
// layer says about a render makes it exit with 2 and fails the test that caused it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fringe::cli {

using Arguments = std::vector<std::string>;
using Seconds = std::chrono::duration<double>;

struct Surroundings {
    std::filesystem::path folder = "/";                   // the working directory
    std::map<std::string, std::string> environment = {};  // added to the test's own
    bool terminal = false;                                // standard error is a terminal
    std::optional<std::string> output = {};               // standard output goes to this file
    std::optional<std::size_t> largestFile = {};          // bytes; a longer file fails as on a full disk
};

struct Outcome {
    int status = 0;     // as the shell's $?: 128 + N after death by signal N
    std::string out;    // standard output
    std::string err;    // standard error
    Seconds runTime{};  // since the start, or since the last signal
};

// A running fringe.
class Program {
public:
    explicit Program(const Arguments& arguments, const Surroundings& surroundings = {});
    ~Program();  // kills it if it still runs
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // Waits until standard error holds `text`. False if the program ends before.
    bool says(const std::string& text);

    // Lets it run on; false if it ends meanwhile.
    bool runsFor(Seconds time);

    void signal(int number);

    // Waits for the end. Throws std::runtime_error if it does not come within a minute, as does says().
    Outcome wait();

private:
    using Clock = std::chrono::steady_clock;

    bool read(Clock::time_point until);

    pid_t process_ = -1;  // -1 when it has ended
    int out_ = -1;        // -1 at the end of the stream
    int err_ = -1;
    Clock::time_point start_ = Clock::now();
    Outcome outcome_;
};

// Runs it to the end.
Outcome run(const Arguments& arguments, const Surroundings& surroundings = {});

}  // namespace fringe::cli
