#include "cli/program.hpp"

#include <fcntl.h>
#include <linux/capability.h>
#include <poll.h>
#include <pty.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace fringe::cli {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 60s;  // many times what any run takes; reached only when the program hangs

struct Ends {
    int reading;
    int writing;
};

// Not inherited by other programs, so that the end of the stream is the end of this one.
Ends openPipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    return {ends[0], ends[1]};
}

Ends openTerminal() {
    Ends ends{};
    if (::openpty(&ends.reading, &ends.writing, nullptr, nullptr, nullptr) != 0)
        throw std::system_error(errno, std::generic_category(), "openpty");
    ::fcntl(ends.reading, F_SETFD, FD_CLOEXEC);
    ::fcntl(ends.writing, F_SETFD, FD_CLOEXEC);
    return ends;
}

// In the child. Only what may be called between fork and exec.
[[noreturn]] void become(const std::vector<char*>& arguments, const std::vector<char*>& environment,
                         const Surroundings& surroundings, int out, int err) {
    const int in = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    if (surroundings.output) out = ::open(surroundings.output->c_str(), O_WRONLY | O_CLOEXEC);
    ::dup2(in, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    if (surroundings.largestFile) {
        ::signal(SIGXFSZ, SIG_IGN);  // write() then fails instead
        const rlimit limit{*surroundings.largestFile, *surroundings.largestFile};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    // Root writes into any folder; without this capability it obeys permissions as users do, who cannot (and
    // need not) give it up.
    ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
    if (::chdir(surroundings.folder.c_str()) == 0)
        ::execve(FRINGE_PROGRAM, arguments.data(), environment.data());
    ::_exit(127);
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

std::vector<std::string> environmentWith(std::map<std::string, std::string> added) {
    added.emplace("FRINGE_VALIDATION", "1");
    std::vector<std::string> all;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        if (!added.contains(text.substr(0, text.find('=')))) all.push_back(text);
    }
    for (const auto& [name, value] : added) all.push_back(name + "=" + value);
    return all;
}

int asShellStatus(int waitStatus) {
    return WIFSIGNALED(waitStatus) ? 128 + WTERMSIG(waitStatus) : WEXITSTATUS(waitStatus);
}

// Appends what is there to `text`; closes the stream at its end.
void receive(int& stream, std::string& text) {
    std::array<char, 4096> buffer{};
    const ssize_t size = ::read(stream, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) return;
    if (size > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(size));
        return;
    }
    ::close(stream);  // a terminal ends with EIO, a pipe with nothing read
    stream = -1;
}

}  // namespace

Program::Program(const Arguments& arguments, const Surroundings& surroundings) {
    std::vector<std::string> words{"fringe"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environmentWith(surroundings.environment);
    const std::vector<char*> argv = pointersTo(words);
    const std::vector<char*> environment = pointersTo(variables);
    const Ends out = openPipe();
    const Ends err = surroundings.terminal ? openTerminal() : openPipe();

    process_ = ::fork();
    if (process_ == 0) become(argv, environment, surroundings, out.writing, err.writing);
    ::close(out.writing);
    ::close(err.writing);
    out_ = out.reading;
    err_ = err.reading;
    if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
}

Program::~Program() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    for (const int stream : {out_, err_}) {
        if (stream >= 0) ::close(stream);
    }
}

// Reads what comes next. False when both streams are at their end, or it is late.
bool Program::read(Clock::time_point until) {
    if (out_ < 0 && err_ < 0) return false;
    std::array<pollfd, 2> streams{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0 || ::poll(streams.data(), streams.size(), static_cast<int>(left)) == 0) return false;
    if (streams[0].revents != 0) receive(out_, outcome_.out);
    if (streams[1].revents != 0) receive(err_, outcome_.err);
    return true;
}

bool Program::says(const std::string& text) {
    const auto latest = Clock::now() + kPatience;
    while (outcome_.err.find(text) == std::string::npos) {
        if (read(latest)) continue;
        if (Clock::now() >= latest) throw std::runtime_error("fringe hangs without saying \"" + text + "\"");
        return false;
    }
    return true;
}

bool Program::runsFor(Seconds time) {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
    while (read(end)) {
    }
    return Clock::now() >= end;
}

void Program::signal(int number) {
    start_ = Clock::now();
    ::kill(process_, number);
}

Outcome Program::wait() {
    const auto latest = Clock::now() + kPatience;
    while (read(latest)) {
    }
    if (Clock::now() >= latest) throw std::runtime_error("fringe hangs");
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    outcome_.status = asShellStatus(status);
    outcome_.runTime = Clock::now() - start_;
    return outcome_;
}

Outcome run(const Arguments& arguments, const Surroundings& surroundings) {
    return Program(arguments, surroundings).wait();
}

}  // namespace fringe::cli
