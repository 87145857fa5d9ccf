// The options of how a picture is measured, developed and stored.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "image/writer.hpp"
#include "scene/scene.hpp"

namespace fringe::cli {

// As given; empty where the command line says nothing.
struct PictureOptions {
    int pngBits = 8;
    std::string exrType;
    std::string exrColor = "rgb";
    std::string quantity = "color";
    std::string colorSpace;
    std::string exposure;
    std::string toneCurve = "linear";
};

void addPictureOptions(CLI::App& command, PictureOptions& options);

image::Quantity quantityOf(const PictureOptions& options);

// The command line's colour space and exposure in place of the scene's. Throws InputError.
void applyTo(scene::Image& image, const PictureOptions& options);

// How the pictures of a scene are written; without metadata, and without exposure, which may yet have to be
// found. Throws InputError when the scene's white balance is for a light that cannot look white.
image::OutputOptions outputOptions(const PictureOptions& options, const scene::Scene& scene);

// What differs from the default, for the metadata: ", colour space display-p3, quantity luminance".
std::string pictureText(const PictureOptions& options, const scene::Image& image);

}  // namespace fringe::cli
