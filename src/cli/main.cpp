// The program: reads the command line, runs the chosen sub-command, and turns every error into a message on
// standard error and an exit status. Nothing below this file prints an error or exits.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/outputs.hpp"
#include "gpu/device.hpp"
#include "image/compare.hpp"
#include "image/file_error.hpp"
#include "profile/surface.hpp"
#include "version.hpp"

namespace {

using namespace fringe;

int fail(int status, const std::string& message) {
    fmt::print(stderr, "fringe: {}\n", message);
    return status;
}

int run(int argc, char** argv) {
    CLI::App app("Fringe renders light that has passed a diffraction grating.", "fringe");
    app.set_version_flag("--version",
                         fmt::format("fringe {} (commit {})\ncompiler {}\nVulkan headers {}", cli::kVersion,
                                     cli::kCommit, cli::kCompiler, cli::kVulkanHeaders));
    app.require_subcommand(0, 1);  // none is refused below, so that a misspelt one is named in the message
    cli::Command chosen;
    cli::addRender(app, chosen);
    cli::addPreview(app, chosen);
    cli::addValidate(app, chosen);
    cli::addInfo(app, chosen);
    cli::addDevices(app, chosen);
    cli::addProfile(app, chosen);
    cli::addCompare(app, chosen);
    cli::addStress(app, chosen);
    cli::addBench(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? cli::kDone : cli::kWrongInput;  // prints help, version or what is wrong
    }
    if (!chosen) return fail(cli::kWrongInput, "no sub-command given; fringe --help lists them");
    const int status = chosen();
    if (std::fflush(stdout) != 0) throw std::system_error(errno, std::generic_category());
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const scene::SceneError& error) {
        fmt::print(stderr, "{}\n", error.what());  // one line a problem, each with its place
        return cli::kWrongInput;
    } catch (const cli::InputError& error) {
        return fail(cli::kWrongInput, error.what());
    } catch (const profile::LineError& error) {
        return fail(cli::kWrongInput, error.what());
    } catch (const image::MismatchError& error) {
        return fail(cli::kWrongInput, error.what());
    } catch (const image::FileError& error) {
        return fail(cli::kWrongInput, error.what());
    } catch (const cli::NothingWritten& error) {
        return fail(cli::kMachineCannot, error.what());
    } catch (const cli::NoWindow& error) {
        return fail(cli::kMachineCannot, error.what());
    } catch (const gpu::DeviceError& error) {
        return fail(cli::kMachineCannot, error.what());
    } catch (const std::bad_alloc&) {
        return fail(cli::kMachineCannot, "this machine is out of memory; render a smaller picture");
    } catch (const std::exception& error) {
        if (std::ferror(stdout) != 0) {
            return fail(cli::kMachineCannot,
                        fmt::format("standard output cannot be written: {}", error.what()));
        }
        return fail(cli::kMachineCannot, fmt::format("unexpected error, please report it: {}", error.what()));
    }
}
