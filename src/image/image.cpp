#include "image/image.hpp"

#include <cassert>

namespace fringe::image {

const char* nameOf(Quantity quantity) {
    switch (quantity) {
        case Quantity::color:
            return "color";
        case Quantity::luminance:
            return "luminance";
        case Quantity::radiance:
            return "radiance";
        case Quantity::irradiance:
            return "irradiance";
    }
    assert(false);
    return "";
}

const char* unitOf(Quantity quantity) {
    switch (quantity) {
        case Quantity::color:
            return "";
        case Quantity::luminance:
            return "cd/m^2";
        case Quantity::radiance:
            return "W/(m^2 sr)";
        case Quantity::irradiance:
            return "W/m^2";
    }
    assert(false);
    return "";
}

}  // namespace fringe::image
