#include "render/pieces.hpp"

#include <algorithm>

namespace fringe::render {
namespace {

constexpr std::uint32_t kEdge = compile::LitTiles::kEdge;

// Pixels behind `from` up to the end of its tile, or of the rectangle.
std::uint32_t upToTileEnd(std::uint32_t from, std::uint32_t end) {
    return std::min((from / kEdge + 1) * kEdge, end) - from;
}

// One row of tiles: neighbours alike are one piece.
std::vector<Piece> runsOf(const Piece& strip, const compile::LitTiles& tiles) {
    std::vector<Piece> runs;
    const std::uint32_t row = std::min(strip.y / kEdge, tiles.rows - 1), end = strip.x + strip.width;
    for (std::uint32_t x = strip.x; x < end;) {
        const std::uint32_t width = upToTileEnd(x, end);
        const bool isLit = tiles.at(std::min(x / kEdge, tiles.columns - 1), row);
        if (!runs.empty() && runs.back().isLit == isLit) runs.back().width += width;
        else runs.push_back({x, strip.y, width, strip.height, isLit});
        x += width;
    }
    return runs;
}

}  // namespace

std::vector<Piece> piecesOf(const Piece& whole, const compile::LitTiles& tiles) {
    if (!tiles.isKnown()) return {{whole.x, whole.y, whole.width, whole.height, true}};
    std::vector<Piece> pieces;
    const std::uint32_t end = whole.y + whole.height;
    for (std::uint32_t y = whole.y; y < end;) {
        const std::uint32_t height = upToTileEnd(y, end);
        for (const Piece& run : runsOf({whole.x, y, whole.width, height, false}, tiles)) {
            const auto above = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
                return piece.y + piece.height == y && piece.x == run.x && piece.width == run.width &&
                       piece.isLit == run.isLit;
            });
            if (above != pieces.end()) above->height += height;
            else pieces.push_back(run);
        }
        y += height;
    }
    return pieces;
}

}  // namespace fringe::render
