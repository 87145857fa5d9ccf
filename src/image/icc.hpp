// ICC profiles by Little CMS: made for the colour spaces that PNG has no chunk for, and read from any PNG.
// Internal to the image library.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "image/color_space.hpp"

namespace fringe::image {

// The name of a colour space, as its profile and users have it.
const char* nameOf(ColorSpace space);

// A display profile of version 4; the same bytes every time.
std::vector<std::uint8_t> iccProfile(ColorSpace space);

// Encoded RGB of a profile to linear sRGB, relative to white; not clipped, so colours out of the gamut of
// sRGB come out below 0 or above 1 and are not lost.
class IccDecoder {
public:
    // Nothing when the bytes are no profile of an RGB device.
    static std::optional<IccDecoder> create(std::span<const std::uint8_t> profile);

    // In place: red, green, blue, red, ...; encoded 0..1 to linear.
    void decode(std::span<float> rgb) const;

private:
    using Transform = std::unique_ptr<void, void (*)(void*)>;
    explicit IccDecoder(Transform transform) : transform_(std::move(transform)) {}

    Transform transform_;
};

}  // namespace fringe::image
