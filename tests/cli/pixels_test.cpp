// Same scene, same device, same pixels: to the last bit, from run to run and for any tile size.
#include <algorithm>
#include <cstring>

#include "cli/support.hpp"
#include "image/reader.hpp"

namespace fringe::cli {
namespace {

// The room: 150 x 130 pixels, so that tiles of 16 and 64 are cut at the edges and the default (128 at first)
// makes several.
class PixelsOnDevice : public testing::Test {
protected:
    image::Picture render(int samples, const Arguments& arguments = {}) {
        const std::string path = (folder_ / "a.exr").string();
        expectDone(run(Arguments{"render", roomFile(), "-o", path, "--exr-type", "float", "--set",
                                 "image.samples=" + std::to_string(samples)} +
                       arguments));
        return image::readImage(path);
    }

private:
    TestFolder folder_;
};

// Pixels that are not the same to the last bit.
std::size_t different(const image::Picture& a, const image::Picture& b) {
    if (a.width != b.width || a.height != b.height) return std::max(a.pixels.size(), b.pixels.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        count += std::memcmp(&a.pixels[i].r, &b.pixels[i].r, 3 * sizeof(float)) != 0 ? 1 : 0;
    }
    return count;
}

class SamePixelsOnDevice : public PixelsOnDevice, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Samples, SamePixelsOnDevice, testing::Values(1, 5),
                         testing::PrintToStringParamName());

TEST_P(SamePixelsOnDevice, FromRunToRunAndForAnyTile) {
    const image::Picture first = render(GetParam());
    EXPECT_EQ(different(first, render(GetParam())), 0U);
    for (const char* tile : {"16", "64", "1000"}) {
        EXPECT_EQ(different(first, render(GetParam(), {"--tile", tile})), 0U) << "tile " << tile;
    }
}

TEST_F(PixelsOnDevice, OfSeveralSamplesDependOnTheSeed) {
    const std::size_t changed = different(render(5), render(5, {"--set", "image.seed=1"}));
    // The lamp's soft light reaches most of the room, and each of its pixels takes other points of the lamp.
    EXPECT_GT(changed, std::size_t{150} * 130 / 4);
}

}  // namespace
}  // namespace fringe::cli
