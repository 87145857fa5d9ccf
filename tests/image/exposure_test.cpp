// Automatic exposure on pictures whose answer is known, and the spool that keeps them meanwhile.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "image/exposure_meter.hpp"
#include "image/pictures.hpp"
#include "image/spool.hpp"

namespace fringe::image {
namespace {

// A bin of the meter spans a 128th of an octave or less, so its middle errs by a 128th of a stop at most; the
// result is then rounded by half a hundredth.
constexpr double kBound = 1.0 / 128.0 + 0.005;

double metered(const std::vector<Pixel>& pixels, const Development& development = {}) {
    ExposureMeter meter(development);
    meter.add(pixels);
    return meter.exposure();
}

Pixel grey(double value) {
    return filmOf(glm::dvec3(value));
}

TEST(AutoExposure, PutsWhatIsEvenHalfAStopBelowWhite) {
    for (const double value : {1e-6, 0.003, 0.7, 1.0, 5000.0})
        EXPECT_NEAR(metered(std::vector<Pixel>(100, grey(value))), -0.5 - std::log2(value), kBound) << value;
}

// Fringes in a 200th of the picture: black, or the tails of the pattern around them, do not count.
TEST(AutoExposure, ExposesForThinFringesInTheDark) {
    for (const double dark : {0.0, 1e-9, 1e-4}) {
        std::vector<Pixel> pixels(20000, grey(dark));
        for (std::size_t i = 0; i < pixels.size(); i += 200) pixels[i] = grey(8.0);
        EXPECT_NEAR(metered(pixels), -0.5 - 3.0, kBound) << dark;
    }
}

// The percentile: of a ramp it is 0.99 of the brightest.
TEST(AutoExposure, IsSetByThe99thPercentile) {
    std::vector<Pixel> pixels;
    for (int i = 1; i <= 10000; ++i) pixels.push_back(grey(i / 10000.0));
    EXPECT_NEAR(metered(pixels), -0.5 - std::log2(0.99), kBound + 1e-3);
}

TEST(AutoExposure, ASmallLampDoesNotCount) {
    std::vector<Pixel> pixels(1000, grey(0.25));
    for (std::size_t i = 0; i < 9; ++i) pixels[i] = grey(100.0);
    EXPECT_NEAR(metered(pixels), -0.5 + 2.0, kBound);
}

// The red of sRGB at luminance 0.2126 has its red channel at 1: at that, and not at the luminance, it is
// metered.
TEST(AutoExposure, KeepsSaturatedColors) {
    EXPECT_NEAR(metered(std::vector<Pixel>(10, filmOf(glm::dvec3(1.0, 0.0, 0.0)))), -0.5, kBound);
    // Beyond the gamut it is metered as what it will be shown as: developing clips nothing.
    const Pixel pure{0.2835F, 0.1070F, 0.0F, false};  // 650 nm
    const double exposure = metered({pure});
    const DisplayColor shown = DisplayTransform({.exposure = exposure})(pure);
    const glm::dvec3 mapped = intoGamut(shown);
    EXPECT_NEAR(mapped.x, std::sqrt(0.5), std::sqrt(0.5) * kBound);
    EXPECT_NEAR(std::min(mapped.y, mapped.z), 0.0, 1e-15);
}

TEST(AutoExposure, IsThatOfTheBalancedPicture) {
    const glm::dvec3 lamp(1.09850, 1.0, 0.35585);
    const Pixel paper{1.09850F * 0.5F, 0.5F, 0.35585F * 0.5F, false};
    EXPECT_NEAR(metered({paper}, {.whiteBalance = adaptation(lamp, displayWhite()).value()}), 0.5, kBound);
    EXPECT_NEAR(metered({grey(0.5)}, {.exposure = 5.0}), 0.5, kBound) << "an exposure given does not count";
}

TEST(AutoExposure, WithoutLightIsZero) {
    EXPECT_EQ(metered({}), 0.0);
    EXPECT_EQ(metered(std::vector<Pixel>(10)), 0.0);
    EXPECT_EQ(metered({{1.0F, 1.0F, 1.0F, true}, {0.0F, std::nanf(""), 0.0F, false}}), 0.0);
}

TEST(AutoExposure, IsFiniteForAnyPicture) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(std::isfinite(metered({{infinity, infinity, infinity, false}})));
    EXPECT_TRUE(std::isfinite(metered({{1e38F, 3e38F, 1e38F, false}, {1e-38F, 2e-38F, 1e-38F, false}})));
}

TEST(AutoExposure, BandsGiveTheExposureOfTheWhole) {
    const Image image = testPicture(61, 47);
    ExposureMeter bands({});
    for (std::size_t y = 0; y < 47; ++y) bands.add(std::span(image.pixels).subspan(y * 61, 61));
    EXPECT_EQ(bands.exposure(), metered(image.pixels));
}

// All rows come back in order, whatever was held in memory and whatever in the file.
TEST(Spooling, GivesTheRowsBack) {
    const Image image = testPicture(61, 300);
    const std::size_t row = 61 * sizeof(Pixel);
    for (const std::size_t memory : {std::size_t{0}, 10 * row, 170 * row, Spool::kMemory}) {
        Spool spool(61, memory);
        for (std::size_t y = 0; y < 300; y += 4)
            spool.append(std::span(image.pixels).subspan(y * 61, 4 * 61));
        for (int pass = 0; pass < 2; ++pass) {
            std::vector<Pixel> back;
            spool.replay([&](std::span<const Pixel> rows) {
                EXPECT_EQ(rows.size() % 61, 0U);
                back.insert(back.end(), rows.begin(), rows.end());
            });
            ASSERT_EQ(back.size(), image.pixels.size());
            for (std::size_t i = 0; i < back.size(); ++i)
                ASSERT_EQ(std::memcmp(&back[i], &image.pixels[i], 3 * sizeof(float)), 0) << i;
        }
    }
}

// TMPDIR for the life of a test.
class TemporaryFolder {
public:
    explicit TemporaryFolder(const std::filesystem::path& folder) { ::setenv("TMPDIR", folder.c_str(), 1); }
    ~TemporaryFolder() { ::unsetenv("TMPDIR"); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

std::string messageOfSpooling() {
    const Image image = testPicture(61, 40);
    try {
        Spool spool(61, 0);
        spool.append(image.pixels);
        spool.append(image.pixels);
    } catch (const FileError& error) {
        return error.what();
    }
    return "(no error)";
}

TEST(Spooling, ItsFileHasNoName) {
    const TestFolder folder;
    const TemporaryFolder temporary(folder.path());
    const Image image = testPicture(61, 4);
    Spool spool(61, 0);
    spool.append(image.pixels);
    spool.append(image.pixels);
    EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(Spooling, AFullDiskOrNoFolderIsAnErrorThatNamesTheFolder) {
    const TestFolder folder;
    {
        const TemporaryFolder temporary(folder.path());
        rlimit before{};
        ::getrlimit(RLIMIT_FSIZE, &before);
        const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limited{1000, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limited);
        const std::string message = messageOfSpooling();
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, oldHandler);
        EXPECT_EQ(message, folder.path().string() +
                               ": cannot hold the picture until its exposure is known: File too large");
    }
    const TemporaryFolder missing(folder / "missing");
    EXPECT_EQ(messageOfSpooling(),
              (folder / "missing").string() +
                  ": cannot hold the picture until its exposure is known: No such file or directory");
}

}  // namespace
}  // namespace fringe::image
