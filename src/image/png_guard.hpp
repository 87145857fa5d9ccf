// Calls into libpng that may fail. libpng reports an error by longjmp, which runs no destructor: so every
// call goes through guarded(), whose step holds plain values only, and C++ sees a bool.
// Internal to the image library.
#pragma once

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <type_traits>

namespace fringe::image {

// libpng's message of the last error, kept without allocating: it is written between C frames.
using PngMessage = std::array<char, 128>;

// The error handler of a png_struct whose error pointer is a PngMessage.
[[noreturn]] inline void onPngError(png_structp png, png_const_charp message) {
    auto& kept = *static_cast<PngMessage*>(png_get_error_ptr(png));
    std::snprintf(kept.data(), kept.size(), "%s", message);
    png_longjmp(png, 1);
}

// Warnings are about ancillary chunks, which libpng then leaves out; a library prints nothing.
inline void ignorePngWarning(png_structp, png_const_charp) {}

// Run a step of libpng calls; false when libpng reported an error, after which png is only good to be
// destroyed. The step may own nothing that needs a destructor.
template <class Step>
[[nodiscard]] bool guarded(png_structp png, const Step& step) {
    static_assert(std::is_trivially_destructible_v<Step>);
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    step();
    return true;
}

}  // namespace fringe::image
