// The program: reads the command line, runs the chosen sub-command, and turns every error into a message on
// standard error and an exit status. Nothing below this file prints an error or exits.
#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "gpu/device.hpp"
#include "image/compare.hpp"
#include "image/file_error.hpp"
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
    app.require_subcommand(1);
    cli::Command chosen;
    cli::addRender(app, chosen);
    cli::addValidate(app, chosen);
    cli::addInfo(app, chosen);
    cli::addDevices(app, chosen);
    cli::addCompare(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? cli::kDone : cli::kWrongInput;  // prints help, version or what is wrong
    }
    return chosen();
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
    } catch (const image::SizeError& error) {
        return fail(cli::kWrongInput, error.what());
    } catch (const image::FileError& error) {
        return fail(cli::kWrongInput, error.what());
    } catch (const gpu::DeviceError& error) {
        return fail(cli::kMachineCannot, error.what());
    } catch (const std::bad_alloc&) {
        return fail(cli::kMachineCannot, "this machine is out of memory; render a smaller picture");
    } catch (const std::exception& error) {
        return fail(cli::kMachineCannot, fmt::format("unexpected error, please report it: {}", error.what()));
    }
}
