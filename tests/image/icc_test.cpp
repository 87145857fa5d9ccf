// Pictures in wide colour spaces, judged by Little CMS: what the file's codes and profile mean together must
// be the colours of the film.
#include "image/icc.hpp"

#include <gtest/gtest.h>
#include <lcms2.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "image/pictures.hpp"
#include "image/reader.hpp"
#include "image/writer.hpp"

namespace fringe::image {
namespace {

// What a PNG of 16 bits holds, by libpng alone.
struct Codes {
    std::vector<std::uint16_t> rgb;
    std::vector<std::uint8_t> profile;
    std::string profileName;
};

Codes codesOf(const std::filesystem::path& path) {
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_swap(png);
    png_read_png(png, info, PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
    Codes codes;
    const std::size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    for (std::size_t y = 0; y < height; ++y) {
        const auto* row = reinterpret_cast<const std::uint16_t*>(png_get_rows(png, info)[y]);
        codes.rgb.insert(codes.rgb.end(), row, row + 3 * width);
    }
    png_charp name = nullptr;
    int compression = 0;
    png_bytep bytes = nullptr;
    png_uint_32 size = 0;
    if (png_get_iCCP(png, info, &name, &compression, &bytes, &size) != 0) {
        codes.profile.assign(bytes, bytes + size);
        codes.profileName = name;
    }
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return codes;
}

// XYZ under display white, relative to it, of encoded RGB: by the profile to the connection space, whose
// white is D50, and by Bradford's adaptation from there.
std::vector<glm::dvec3> xyzByLittleCms(const Codes& codes) {
    const cmsHPROFILE encoded =
        cmsOpenProfileFromMem(codes.profile.data(), static_cast<cmsUInt32Number>(codes.profile.size()));
    const cmsHPROFILE connection = cmsCreateXYZProfile();
    const cmsHTRANSFORM transform = cmsCreateTransform(encoded, TYPE_RGB_DBL, connection, TYPE_XYZ_DBL,
                                                       INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
    const glm::dvec3 white = displayWhite();
    const cmsCIEXYZ target{white.x, white.y, white.z};
    std::vector<glm::dvec3> colors;
    for (std::size_t i = 0; i < codes.rgb.size(); i += 3) {
        const double rgb[] = {codes.rgb[i] / 65535.0, codes.rgb[i + 1] / 65535.0, codes.rgb[i + 2] / 65535.0};
        cmsCIEXYZ xyz, adapted;
        cmsDoTransform(transform, rgb, &xyz, 1);
        cmsAdaptToIlluminant(&adapted, cmsD50_XYZ(), &target, &xyz);
        colors.emplace_back(adapted.X, adapted.Y, adapted.Z);
    }
    cmsDeleteTransform(transform);
    cmsCloseProfile(connection);
    cmsCloseProfile(encoded);
    return colors;
}

// Colours of the space that few others hold: its corners, and a random inside.
Image colorsOf(ColorSpace space) {
    const glm::dmat3 matrix = xyzFromLinear(space);
    Image image{16, 16, {}};
    for (unsigned i = 0; i < 256; ++i) {
        const glm::dvec3 rgb((i & 3U) / 3.0, ((i >> 2U) & 3U) / 3.0,
                             ((i >> 4U) & 3U) / 3.0 * (i < 128 ? 1.0 : 0.1));
        const glm::vec3 xyz = matrix * rgb;
        image.pixels.push_back({xyz.x, xyz.y, xyz.z, false});
    }
    return image;
}

class WideGamut : public testing::TestWithParam<ColorSpace> {};
INSTANTIATE_TEST_SUITE_P(Space, WideGamut, testing::Values(ColorSpace::displayP3, ColorSpace::rec2020));

// The profile has the space's white as the standards round it, which puts a colour up to 3e-4 beside where
// the film's white has it; the profile's numbers have a step of 2^-16, nine of which make a colour; half a
// code of 16 bits is below 2e-5 of linear light.
TEST_P(WideGamut, CodesAndProfileMeanTheColorsOfTheFilm) {
    const TestFolder folder;
    const Image image = colorsOf(GetParam());
    writeImage(folder / "a.png", image, {.development = {.colorSpace = GetParam()}, .pngBits = 16});
    const Codes codes = codesOf(folder / "a.png");
    EXPECT_EQ(codes.profileName, nameOf(GetParam()));
    const std::vector<glm::dvec3> colors = xyzByLittleCms(codes);
    ASSERT_EQ(colors.size(), image.pixels.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        EXPECT_NEAR(colors[i].x, image.pixels[i].x, 4e-4) << i;
        EXPECT_NEAR(colors[i].y, image.pixels[i].y, 4e-4) << i;
        EXPECT_NEAR(colors[i].z, image.pixels[i].z, 4e-4) << i;
    }
}

// The reader obeys the profile and clips nothing: what sRGB cannot show comes out below 0 or above 1.
TEST_P(WideGamut, IsReadAsTheSameColors) {
    const TestFolder folder;
    const Image image = colorsOf(GetParam());
    writeImage(folder / "a.png", image, {.development = {.colorSpace = GetParam()}, .pngBits = 16});
    writeImage(folder / "a.exr", image, {.exrFloat = true});
    const Picture shown = readImage(folder / "a.png"), exact = readImage(folder / "a.exr");
    float lowest = 0.0F, largest = 0.0F;
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        // As above; to linear sRGB the errors grow by the matrix, by up to 3.
        EXPECT_NEAR(shown.pixels[i].r, exact.pixels[i].r, 1.2e-3) << i;
        EXPECT_NEAR(shown.pixels[i].g, exact.pixels[i].g, 1.2e-3) << i;
        EXPECT_NEAR(shown.pixels[i].b, exact.pixels[i].b, 1.2e-3) << i;
        lowest = std::min({lowest, shown.pixels[i].r, shown.pixels[i].g});
        largest = std::max(largest, shown.pixels[i].r);
    }
    EXPECT_LT(lowest, -0.2F);
    EXPECT_GT(largest, 1.2F);
}

TEST_P(WideGamut, AProfileIsTheSameEveryTime) {
    std::vector<std::uint8_t> profile = iccProfile(GetParam());
    const std::string header(profile.begin(), profile.begin() + 128);
    EXPECT_EQ(header.substr(24, 4), std::string("\x07\xDF\0\1", 4)) << "not the time of day";
    EXPECT_EQ(header.substr(12, 4), "mntr");
    EXPECT_EQ(header.substr(16, 4), "RGB ");
    EXPECT_EQ(profile, iccProfile(GetParam()));
}

// Chunks as PNG, third edition, has them, found by their names in front of the pixels.
TEST_P(WideGamut, AFileSaysItsSpaceByCodePointsToo) {
    const TestFolder folder;
    writeImage(folder / "a.png", testPicture(3, 2), {.development = {.colorSpace = GetParam()}});
    const std::string bytes = bytesOf(folder / "a.png");
    const std::size_t at = bytes.find("cICP");
    ASSERT_LT(at, bytes.find("IDAT"));
    const std::string points =
        GetParam() == ColorSpace::displayP3 ? std::string("\x0C\x0D\0\1", 4) : std::string("\x09\x0E\0\1", 4);
    EXPECT_EQ(bytes.substr(at + 4, 4), points);
    EXPECT_EQ(bytes.find("sRGB"), std::string::npos);
}

TEST(Profiles, ThatAreNoneAreRefused) {
    EXPECT_FALSE(IccDecoder::create({}));
    EXPECT_FALSE(IccDecoder::create(std::vector<std::uint8_t>(200, 7)));
    // A profile of another kind of device.
    const cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(lab, nullptr, &size);
    std::vector<std::uint8_t> bytes(size);
    cmsSaveProfileToMem(lab, bytes.data(), &size);
    cmsCloseProfile(lab);
    EXPECT_FALSE(IccDecoder::create(bytes));
}

}  // namespace
}  // namespace fringe::image
