// What passes between the window and the renderer behind it: wishes one way, pictures the other.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "image/develop.hpp"
#include "image/image.hpp"
#include "preview/switches.hpp"
#include "scene/parse.hpp"

namespace fringe::preview {

// A scene file as it is edited.
struct Source {
    std::string text;
    std::string file;  // for messages, and where the files are that it names
    std::vector<scene::Override> overrides;
};

// The last two show one wavelength (Switches::wavelength_nm), in its colour or in grey.
enum class View { color, decades, wavelength, greyWavelength };

inline bool showsWavelength(View view) {
    return view == View::wavelength || view == View::greyWavelength;
}

// How a picture is developed.
struct Display {
    double exposure = 0.0;  // stops, added to the scene's own
    View view = View::color;
    image::ToneCurve toneCurve = image::ToneCurve::linear;

    bool operator==(const Display&) const = default;
};

// What the window is to show.
struct Wish {
    std::uint64_t number = 0;              // ascending
    std::shared_ptr<const Source> source;  // another pointer is another scene
    Switches switches;
    std::uint64_t shaders = 0;            // of a folder (LiveShaders): another number is another text
    std::uint64_t cameraNumber = 0;       // another number is another camera
    std::optional<scene::Camera> camera;  // in place of the scene's
    Display display;
    std::uint32_t samples = 1;  // of every pixel, in the end
    bool isMoving = false;      // the next wish comes soon, and a coarse picture does
};

// Milliseconds, each of the last time.
struct Timing {
    double scene = 0.0;           // reading the scene and making its tables
    double pipeline = 0.0;        // compiling one
    double sample = 0.0;          // of all pixels in full size
    double develop = 0.0;         // reading the film and developing it
    std::uint64_t pipelines = 0;  // compiled so far
};

struct Picture {
    std::uint64_t wish = 0;               // the number of the one that it fulfils
    std::uint32_t width = 0, height = 0;  // less than the full size while it is coarse
    std::uint32_t samples = 0;
    bool isComplete = false;                   // in full size, with all samples
    double exposure = 0.0;                     // stops in all: the scene's, the automatic ones and the wish's
    std::vector<std::uint8_t> rgba;            // the fourth does not count
    std::shared_ptr<const image::Image> film;  // in full size; null while it is coarse, and of one wavelength
    image::Development development;            // what a file of it gets
    Timing timing;                             // up to here
    std::shared_ptr<const scene::Scene> scene;
    std::shared_ptr<const Source> source;
};

// What the renderer has to tell beside pictures.
struct State {
    std::string device, driver;       // empty until it is open
    std::string activity;             // what takes time just now; empty: nothing but samples
    std::string error;                // why the last wish is not on show; empty: it is
    std::uint64_t losses = 0;         // of devices so far; the next wish opens another
    std::string shaderError;          // why the shaders on show are not those of the folder
    std::optional<double> measuring;  // the share that is done; none: nothing is being measured
    std::string specialisation;       // the constants of the pipeline that are not 0
    Timing timing;
};

}  // namespace fringe::preview
