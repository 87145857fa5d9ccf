// A rectangle of the picture in pieces that gratings may light and pieces that they do not reach.
#pragma once

#include <cstdint>
#include <vector>

#include "compile/lit_tiles.hpp"

namespace fringe::render {

struct Piece {
    std::uint32_t x, y, width, height;  // pixels of the picture, rounded up to whole workgroups
    bool isLit;
};

// As few as runs of tiles below one another make; all of it is lit where the tiles are not known.
std::vector<Piece> piecesOf(const Piece& whole, const compile::LitTiles& tiles);

}  // namespace fringe::render
