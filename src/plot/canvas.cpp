#include "plot/canvas.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <memory>

#include "image/pending_file.hpp"

namespace fringe::plot {
namespace {

using SurfacePointer = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using ContextPointer = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double kPixelsPerPoint = 2.0;
constexpr double kTitleSize = 15.0;

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

cairo_status_t append(void* file, const unsigned char* bytes, unsigned size) {
    return static_cast<image::PendingFile*>(file)->write(bytes, size) ? CAIRO_STATUS_SUCCESS
                                                                      : CAIRO_STATUS_WRITE_ERROR;
}

void require(cairo_status_t status, const image::PendingFile& file) {
    if (status != CAIRO_STATUS_SUCCESS) file.fail(cairo_status_to_string(status));
}

void drawOn(cairo_surface_t* surface, double scale, const std::function<void(const Canvas&)>& draw,
            const image::PendingFile& file) {
    const ContextPointer context(cairo_create(surface), &cairo_destroy);
    cairo_t* cr = context.get();
    cairo_scale(cr, scale, scale);
    cairo_set_source_rgb(cr, 1.0, 1.0, 1.0);
    cairo_paint(cr);
    cairo_select_font_face(cr, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    draw(Canvas(cr));
    require(cairo_status(cr), file);
}

}  // namespace

void Canvas::line(double x1, double y1, double x2, double y2) const {
    cairo_move_to(cr_, x1, y1);
    cairo_line_to(cr_, x2, y2);
    cairo_stroke(cr_);
}

void Canvas::text(const std::string& words, double x, double y, double size, double anchor,
                  double turn) const {
    const double width = widthOf(words, size);
    cairo_save(cr_);
    cairo_translate(cr_, x, y);
    cairo_rotate(cr_, turn);
    cairo_move_to(cr_, -anchor * width, 0.0);
    cairo_show_text(cr_, words.c_str());
    cairo_restore(cr_);
}

double Canvas::widthOf(const std::string& words, double size) const {
    cairo_set_font_size(cr_, size);
    cairo_text_extents_t extents;
    cairo_text_extents(cr_, words.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::titles(const std::string& title, const std::string& subtitle, double left) const {
    ink(0.1);
    text(title, left, 24.0, kTitleSize, 0.0);
    ink(0.35);
    text(subtitle, left, 42.0, kTextSize, 0.0);
}

bool isChartFile(const std::filesystem::path& path) {
    const std::string extension = extensionOf(path);
    return extension == ".svg" || extension == ".png";
}

void writeDrawing(const std::filesystem::path& path, const std::function<void(const Canvas&)>& draw) {
    assert(isChartFile(path));
    image::PendingFile file(path);
    if (extensionOf(path) == ".svg") {
        const SurfacePointer surface(cairo_svg_surface_create_for_stream(append, &file, kWidth, kHeight),
                                     &cairo_surface_destroy);
        drawOn(surface.get(), 1.0, draw, file);
        cairo_surface_finish(surface.get());
        require(cairo_surface_status(surface.get()), file);
    } else {
        const SurfacePointer surface(
            cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kPixelsPerPoint * kWidth),
                                       static_cast<int>(kPixelsPerPoint * kHeight)),
            &cairo_surface_destroy);
        drawOn(surface.get(), kPixelsPerPoint, draw, file);
        require(cairo_surface_write_to_png_stream(surface.get(), append, &file), file);
    }
    file.commit();
}

}  // namespace fringe::plot
