// The tables beside those of Debian's colord-data, which were transcribed by others: skipped where that
// package is not installed.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "optics/color.hpp"
#include "optics/sources.hpp"

namespace fringe::optics {
namespace {

const std::filesystem::path kColord = "/usr/share/colord";

// A CGATS file: SPECTRAL_START_NM, SPECTRAL_END_NM and the rows between BEGIN_DATA and END_DATA.
struct Cgats {
    double start_nm = 0.0;
    double end_nm = 0.0;
    std::vector<std::vector<double>> sets;

    double wavelength(std::size_t band) const {
        const auto bands = static_cast<double>(sets.front().size());
        return start_nm + (end_nm - start_nm) * static_cast<double>(band) / (bands - 1.0);
    }
};

Cgats read(const std::filesystem::path& path) {
    std::ifstream file(path);
    Cgats cgats;
    bool data = false;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word;
        if (line.starts_with("END_DATA") && !line.starts_with("END_DATA_FORMAT")) break;
        if (data) {
            cgats.sets.emplace_back();
            for (double value = 0.0; words >> value;) cgats.sets.back().push_back(value);
        } else if (words >> word; word == "SPECTRAL_START_NM") {
            std::string quoted;
            words >> quoted;
            cgats.start_nm = std::stod(quoted);
        } else if (word == "SPECTRAL_END_NM") {
            std::string quoted;
            words >> quoted;
            cgats.end_nm = std::stod(quoted);
        } else {
            data = word == "BEGIN_DATA";
        }
    }
    return cgats;
}

TEST(Colord, HasTheSameObserver) {
    const auto path = kColord / "cmf" / "CIE1931-2deg-XYZ.cmf";
    if (!exists(path)) GTEST_SKIP() << "colord-data is not installed";
    const Cgats cmf = read(path);
    ASSERT_EQ(cmf.sets.size(), 3u);
    ASSERT_EQ(cmf.sets[0].size(), 95u);
    int compared = 0;
    for (std::size_t band = 0; band < 95; ++band) {
        const double l_nm = cmf.wavelength(band);
        if (l_nm < kShortestVisible_nm || l_nm > kLongestVisible_nm) continue;
        const glm::dvec3 ours = colorMatching(l_nm);
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(ours[i], cmf.sets[static_cast<std::size_t>(i)][band], 1e-9) << l_nm << " nm";
        ++compared;
    }
    EXPECT_EQ(compared, 81);
}

TEST(Colord, HasTheSameIlluminants) {
    if (!exists(kColord / "illuminant")) GTEST_SKIP() << "colord-data is not installed";
    // D50 has three decimals there, and 0.298 for 0.2987 at 390 nm.
    const struct {
        std::string name;
        int visibleBands;
        double tolerance;
    } illuminants[] = {{"A", 401, 1e-5}, {"D50", 81, 1e-3}, {"D65", 81, 1e-5},
                       {"F2", 81, 1e-5}, {"F7", 81, 1e-5},  {"F11", 81, 1e-5}};
    for (const auto& [name, visibleBands, tolerance] : illuminants) {
        const Cgats illuminant = read(kColord / "illuminant" / ("CIE-" + name + ".sp"));
        ASSERT_EQ(illuminant.sets.size(), 1u) << name;
        const Curve ours = namedSpectrum(name)->density;
        // Ours hold one watt and theirs have a scale of their own: it is that of the sum.
        double sumOfOurs = 0.0;
        double sumOfTheirs = 0.0;
        double highest = 0.0;
        for (std::size_t band = 0; band < illuminant.sets[0].size(); ++band) {
            const double l_nm = illuminant.wavelength(band);
            if (l_nm < kShortestVisible_nm || l_nm > kLongestVisible_nm) continue;
            sumOfOurs += valueAt(ours, l_nm);
            sumOfTheirs += illuminant.sets[0][band];
            highest = std::max(highest, illuminant.sets[0][band]);
        }
        int compared = 0;
        for (std::size_t band = 0; band < illuminant.sets[0].size(); ++band) {
            const double l_nm = illuminant.wavelength(band);
            if (l_nm < kShortestVisible_nm || l_nm > kLongestVisible_nm) continue;
            EXPECT_NEAR(valueAt(ours, l_nm) * sumOfTheirs / sumOfOurs, illuminant.sets[0][band],
                        tolerance * highest)
                << name << ' ' << l_nm << " nm";
            ++compared;
        }
        EXPECT_EQ(compared, visibleBands) << name;
    }
}

}  // namespace
}  // namespace fringe::optics
