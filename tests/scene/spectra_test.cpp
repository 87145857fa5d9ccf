// Spectra, reflectances and efficiencies, as keys and from files: what they become, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "optics/color.hpp"
#include "optics/sources.hpp"
#include "scene/folder.hpp"
#include "scene/schema.hpp"
#include "scene/support.hpp"

namespace fringe::scene {
namespace {

using units::nm;

// A point light whose spectrum is on line 9 from column 13.
std::string lightWith(std::string_view spectrum, std::string_view color = "[1, 1, 1]") {
    return sceneWith("", fmt::format(R"({{"type": "point", "position": [0, 0, 0], "power": "1 W", "color": {},
"spectrum": {}}})",
                                     color, spectrum));
}

optics::Spectrum spectrumOf(std::string_view spectrum, const std::string& fileName = "s") {
    return parseScene(lightWith(spectrum), fileName).lights.at(0).spectrum;
}

optics::Curve reflectanceOf(std::string_view reflectance, const std::string& fileName = "s") {
    const Scene scene = parseScene(
        sceneWithMaterial(fmt::format(R"({{"type": "diffuse", "reflectance": {}}})", reflectance)), fileName);
    return std::get<Diffuse>(scene.materials.at(0).model).reflectance;
}

// The reflectance is on line 3 from column 56.
std::string problemsOfReflectance(std::string_view reflectance, const std::string& fileName = "s") {
    try {
        reflectanceOf(reflectance, fileName);
        return "no problem";
    } catch (const SceneError& error) {
        return error.problems().at(0).message;
    }
}

std::string problemsOfFile(const std::string& scene, const std::string& fileName) {
    try {
        parseScene(scene, fileName);
        return "no problem";
    } catch (const SceneError& error) {
        return error.problems().at(0).message;
    }
}

double totalOf(const optics::Spectrum& spectrum) {
    double lines = 0.0;
    for (const optics::Line& line : spectrum.lines) lines += line.power;
    return lines + optics::visiblePower({spectrum.density, {}});
}

// What the visible part of a line is known to.
constexpr double kLine = 1e-9;

// ---- spectra -------------------------------------------------------------------------------------

TEST(SceneSpectra, NamesAreThoseOfTheLibrary) {
    const Property* lights = sceneSchema().find("lights");
    const Schema& names =
        lights->schema.items->alternatives.front().find("spectrum")->schema.alternatives.front();
    std::vector<std::string> written;
    for (const Json::Value& name : names.choices) written.push_back(name.asString());
    std::vector<std::string> known(optics::namedSpectra().begin(), optics::namedSpectra().end());
    std::sort(written.begin(), written.end());
    std::sort(known.begin(), known.end());
    EXPECT_EQ(written, known);
}

TEST(SceneSpectra, DaylightIsTheDefaultOfEveryLight) {
    const Scene scene = parseScene(sceneWith("", R"({"type": "point", "position": [0, 0, 0], "power": "1 W"},
{"type": "directional", "direction": [0, 0, 1], "irradiance": "1 W/m^2"},
{"type": "environment", "radiance": "1 W/m^2/sr"},
{"type": "grating", "position": [0, 0, 0], "normal": [0, 0, 1], "slit_direction": [0, 1, 0],
"aperture": {"type": "circle", "diameter": "1 um"}, "beam": {"diameter": "2 mm"}})"),
                                   "s");
    for (const Light& light : scene.lights)
        EXPECT_EQ(light.spectrum.density, optics::namedSpectrum("D65")->density);
}

TEST(SceneSpectra, Laser) {
    const auto laser = spectrumOf(R"({"type": "laser", "wavelength": "632.8 nm", "linewidth": "0.01 nm"})");
    ASSERT_EQ(laser.lines.size(), 1U);
    EXPECT_EQ(laser.lines[0].wavelength, 632.8 * nm);
    EXPECT_EQ(laser.lines[0].width, 0.01 * nm);
    EXPECT_NEAR(laser.lines[0].power, 1.0, kLine);
    EXPECT_TRUE(laser.density.empty());
    EXPECT_EQ(spectrumOf(R"({"type": "laser", "wavelength": "532 nm"})").lines[0].width, units::Length{});
}

TEST(SceneSpectra, BlackBodyAndLed) {
    EXPECT_EQ(spectrumOf(R"({"type": "blackbody", "temperature": "3200 K"})").density,
              optics::planck(3200.0).density);
    EXPECT_EQ(spectrumOf(R"({"type": "led", "wavelength": "530 nm", "width": "30 nm"})").density,
              optics::led(530.0 * nm, 30.0 * nm).density);
}

TEST(SceneSpectra, LinesShareOneWatt) {
    const auto lines = spectrumOf(R"({"type": "lines", "linewidth": "1 nm", "lines": [
        {"wavelength": "500 nm", "power": 3}, {"wavelength": "600 nm"}]})");
    ASSERT_EQ(lines.lines.size(), 2U);
    EXPECT_NEAR(lines.lines[0].power, 0.75, kLine);
    EXPECT_NEAR(lines.lines[1].power, 0.25, kLine);
    EXPECT_EQ(lines.lines[1].width, 1.0 * nm);
}

TEST(SceneSpectra, SumsWeighWatts) {
    const auto sum = spectrumOf(R"({"type": "sum", "parts": [{"weight": 3, "spectrum": "E"},
        {"spectrum": {"type": "laser", "wavelength": "532 nm"}}]})");
    ASSERT_EQ(sum.lines.size(), 1U);
    EXPECT_NEAR(sum.lines[0].power, 0.25, 1e-14);                           // sums of hundreds of pieces
    EXPECT_NEAR(optics::valueAt(sum.density, 500.0), 0.75 / 400.0, 1e-15);  // equal energy over 400 nm
    EXPECT_NEAR(totalOf(sum), 1.0, 1e-14);
}

TEST(SceneSpectra, FileHoldsAnyUnitOfPower) {
    const Folder folder;
    folder.write("lamp.csv", "# a ramp\nnm,power\n480,0\n580,100\n");
    const auto lamp = spectrumOf(R"({"type": "csv", "file": "lamp.csv"})", folder / "scene.json");
    EXPECT_NEAR(optics::valueAt(lamp.density, 530.0), 1.0 / 100.0, 1e-15);  // half of 2 / 100 nm
    EXPECT_EQ(optics::valueAt(lamp.density, 590.0), 0.0);
}

TEST(SceneSpectra, ColorIsAFilter) {
    const Light light = parseScene(lightWith("\"E\"", "[0.5, 0.5, 0.5]"), "s").lights.at(0);
    EXPECT_NEAR(optics::visiblePower(light.spectrum), 0.5, 1e-12);  // quadrature of a constant
    const Light red = parseScene(lightWith("\"D65\"", "[1, 0, 0]"), "s").lights.at(0);
    const dvec3 rgb =
        optics::linearSrgbFromXyz() * optics::xyzPerWatt(red.spectrum, optics::constantCurve(1.0));
    // The product of two linear pieces is kept to 1e-6 of its peak, and the basis to 1e-6.
    EXPECT_NEAR(rgb.r, 1.0, 3e-6);
    EXPECT_NEAR(rgb.g, 0.0, 3e-6);
    EXPECT_NEAR(rgb.b, 0.0, 3e-6);
}

TEST(SceneSpectra, WhiteBalance) {
    const Scene scene = parseScene(
        sceneWithCamera(
            R"({"position": [0, 0, 3], "target": [0, 0, 0], "white_balance": {"type": "blackbody", "temperature": "2856 K"}})"),
        "s");
    EXPECT_EQ(scene.camera.whiteBalance->density, optics::planck(2856.0).density);
}

TEST(SceneSpectra, WavelengthsNobodySeesAreRefused) {
    EXPECT_EQ(
        problemsOf(lightWith(R"({"type": "laser", "wavelength": "1064 nm"})")),
        R"(s:9:45: "wavelength" is "1064 nm"; write a wavelength from 380 nm to 780 nm (outside this range the eye sees nothing, and nothing is simulated))");
    EXPECT_EQ(
        problemsOf(lightWith(R"({"type": "lines", "lines": [{"wavelength": "0.2 um"}]})")),
        R"(s:9:56: "wavelength" is "0.2 um"; write a wavelength from 380 nm to 780 nm (outside this range the eye sees nothing, and nothing is simulated))");
}

TEST(SceneSpectra, UnknownOnesNameTheNearest) {
    EXPECT_EQ(problemsOf(lightWith("\"sodum\"")), R"(s:9:13: "spectrum" is "sodum"; did you mean "sodium"?)");
    EXPECT_EQ(problemsOf(lightWith("6500")), R"(s:9:13: "spectrum" is 6500; write a spectrum such as "D65")");
    EXPECT_EQ(problemsOf(lightWith(R"({"type": "lasr"})")),
              R"(s:9:22: "type" is "lasr"; did you mean "laser"?)");
    EXPECT_EQ(
        problemsOf(lightWith(R"({"type": "blackbody", "temperature": 3200})")),
        R"(s:9:50: "temperature" is the bare number 3200, which has no unit; write a temperature such as "3200 K")");
}

TEST(SceneSpectra, WithoutPowerAreRefused) {
    EXPECT_EQ(problemsOf(lightWith(R"({"type": "lines", "lines": [{"wavelength": "500 nm", "power": 0}]})")),
              "s:9:40: all lines have the power 0; give one of them more");
    EXPECT_EQ(problemsOf(lightWith(R"({"type": "sum", "parts": [{"spectrum": "A", "weight": 0}]})")),
              "s:9:38: all parts have the weight 0; give one of them more");
}

// ---- files ---------------------------------------------------------------------------------------

TEST(SceneSpectra, FilesThatCannotBeUsedSayWhy) {
    const Folder folder;
    folder.write("wrong.csv", "400,1\n500;2\n600,3\n");
    folder.write("infrared.csv", "800,1\n900,1\n");
    folder.write("dark.csv", "400,0\n700,0\n");
    std::filesystem::create_directory(folder / "sub");
    const auto problem = [&](std::string_view file) {
        return problemsOfFile(lightWith(fmt::format(R"({{"type": "csv", "file": "{}"}})", file)),
                              folder / "scene.json");
    };
    const std::string remedy = "write the path of a CSV file, relative to the folder of the scene file";
    EXPECT_EQ(problem("none.csv"), fmt::format("\"{}\" does not exist; {}", folder / "none.csv", remedy));
    EXPECT_EQ(problem("sub"), fmt::format("\"{}\" is no file; {}", folder / "sub", remedy));
    EXPECT_EQ(problem("wrong.csv").substr(0, 10), "line 2 of ");
    EXPECT_EQ(problem("infrared.csv").substr(0, 10), "line 2 of ");
    EXPECT_EQ(problem("dark.csv"),
              fmt::format("\"{}\" is 0 from 380 nm to 780 nm; write a file with some visible light",
                          folder / "dark.csv"));
}

TEST(SceneSpectra, ProblemsOfFilesHaveAPlace) {
    EXPECT_EQ(
        problemsOf(lightWith(R"({"type": "csv", "file": "no such file"})")),
        R"(s:9:37: "no such file" does not exist; write the path of a CSV file, relative to the folder of the scene file)");
    EXPECT_EQ(
        problemsOf(lightWith("\"E\""), {{"lights.0.spectrum", R"({"type": "csv", "file": "gone.csv"})"}}),
        R"(--set lights.0.spectrum={"type": "csv", "file": "gone.csv"}: "gone.csv" does not exist; write the path of a CSV file, relative to the folder of the scene file)");
}

// ---- reflectances --------------------------------------------------------------------------------

TEST(SceneReflectance, TableGoesOnToTheEndsOfTheVisible) {
    const optics::Curve curve =
        reflectanceOf(R"({"type": "table", "wavelengths": ["500 nm", "0.6 um"], "values": [0.25, 0.75]})");
    EXPECT_EQ(optics::valueAt(curve, 380.0), 0.25);
    EXPECT_DOUBLE_EQ(optics::valueAt(curve, 550.0), 0.5);
    EXPECT_EQ(optics::valueAt(curve, 780.0), 0.75);
    EXPECT_TRUE(optics::isConstant(
        reflectanceOf(R"({"type": "table", "wavelengths": ["500 nm"], "values": [0.25]})")));
}

TEST(SceneReflectance, File) {
    const Folder folder;
    folder.write("paint.csv", "400,0.25\n700,1\n");
    const optics::Curve curve =
        reflectanceOf(R"({"type": "csv", "file": "paint.csv"})", folder / "scene.json");
    EXPECT_EQ(optics::valueAt(curve, 380.0), 0.25);
    EXPECT_DOUBLE_EQ(optics::valueAt(curve, 500.0), 0.5);
    EXPECT_EQ(optics::valueAt(curve, 780.0), 1.0);
}

TEST(SceneReflectance, ProblemsOfTablesAndFiles) {
    EXPECT_EQ(
        problemsOfReflectance(R"({"type": "table", "wavelengths": ["500 nm", "600 nm"], "values": [0.5]})"),
        "there are 1 values for 2 wavelengths; write as many");
    EXPECT_EQ(problemsOfReflectance(
                  R"({"type": "table", "wavelengths": ["500 nm", "0.5 um"], "values": [0.5, 0.5]})"),
              R"(the wavelength "0.5 um" is not above the one before it, "500 nm"; write them ascending)");
    const Folder folder;
    folder.write("percent.csv", "400,25\n700,50\n");
    EXPECT_EQ(
        problemsOfReflectance(R"({"type": "csv", "file": "percent.csv"})", folder / "scene.json"),
        fmt::format("\"{}\" has the value 25 at 400 nm; write values from 0 to 1", folder / "percent.csv"));
}

// ---- efficiencies --------------------------------------------------------------------------------

std::string discWith(std::string_view efficiencies) {
    return sceneWithMaterial(
        fmt::format(R"({{"type": "optical-disc", "medium": "cd", "efficiencies": {}}})", efficiencies));
}

std::vector<OrderEfficiency> efficienciesOf(std::string_view efficiencies,
                                            const std::string& fileName = "s") {
    const Scene scene = parseScene(discWith(efficiencies), fileName);
    return std::get<OpticalDisc>(scene.materials.at(0).model).efficiencies;
}

TEST(SceneEfficiencies, ComeByAscendingOrder) {
    const auto orders = efficienciesOf(R"({"1": 0.125, "-12": 0.25, "0": {"type": "table",
        "wavelengths": ["400 nm", "700 nm"], "values": [0.5, 0.25]}})");
    ASSERT_EQ(orders.size(), 3U);
    EXPECT_EQ(orders[0].order, -12);
    EXPECT_EQ(orders[0].efficiency, optics::constantCurve(0.25));
    EXPECT_EQ(orders[1].order, 0);
    EXPECT_EQ(optics::valueAt(orders[1].efficiency, 780.0), 0.25);
    EXPECT_EQ(orders[2].order, 1);
}

TEST(SceneEfficiencies, FileHasAColumnForEachOrder) {
    const Folder folder;
    folder.write("orders.csv", "# measured\nnm, 0, -1\n\n400, 0.5, 0.25\n# between\n700, 0.25, 0.125\n");
    const auto orders = efficienciesOf(R"({"file": "orders.csv"})", folder / "scene.json");
    ASSERT_EQ(orders.size(), 2U);
    EXPECT_EQ(orders[0].order, -1);
    EXPECT_EQ(optics::valueAt(orders[0].efficiency, 400.0), 0.25);
    EXPECT_EQ(orders[1].order, 0);
    EXPECT_EQ(optics::valueAt(orders[1].efficiency, 780.0), 0.25);
}

TEST(SceneEfficiencies, NoLightIsMade) {
    EXPECT_EQ(problemsOf(discWith(R"({"0": 0.75, "1": 0.25})")), "no problem");
    EXPECT_EQ(problemsOf(discWith(R"({"0": 0.75, "1": 0.5})")),
              "s:3:78: the orders together get 1.25 of the light at 380 nm; write at most 1");
    // Each alone is below 1 all over; the sum is above it at the knot in the middle.
    EXPECT_EQ(problemsOf(discWith(R"({"0": 0.75, "1": {"type": "table",
"wavelengths": ["500 nm", "550 nm", "600 nm"], "values": [0, 0.5, 0]}})")),
              "s:3:78: the orders together get 1.25 of the light at 550 nm; write at most 1");
}

TEST(SceneEfficiencies, WrongOrdersAreRefused) {
    EXPECT_EQ(problemsOf(discWith(R"({"first": 0.5})")), R"(s:3:79: "first" is not an order such as "-1")");
    EXPECT_EQ(problemsOf(discWith("{}")),
              R"(s:3:78: "efficiencies" has no order; write one, such as {"1": 0.3}, or leave the key out)");
    const Folder folder;
    const auto problem = [&](std::string_view text) {
        folder.write("orders.csv", text);
        return problemsOfFile(discWith(R"({"file": "orders.csv"})"), folder / "scene.json");
    };
    const std::string file = fmt::format(" of \"{}\": ", folder / "orders.csv");
    EXPECT_EQ(problem("nm, 0, x\n400, 1, 0\n"),
              "line 1" + file + R"("x" is no order; name them, as in "wavelength_nm, -1, 0, 1")");
    EXPECT_EQ(problem("nm, 0, 0\n400, 1, 0\n"), "line 1" + file + "order 0 is there twice; keep one");
    EXPECT_EQ(problem("nm\n400\n"),
              "line 1" + file + R"(names no order; name them, as in "wavelength_nm, -1, 0, 1")");
    EXPECT_EQ(problem("nm, 0, 1\n400, 1\n"),
              "line 2" + file + "has 2 columns; write 3, as in the line that names the orders");
    EXPECT_EQ(problem("nm, 0, 1\n400, 1, 0\n500, 0.5, -0.5\n").substr(0, 7), "line 3 ");
    EXPECT_EQ(problem("# nothing\n"),
              "line 2" + file + R"(there are no lines; begin with "wavelength_nm, -1, 0, 1")");
    EXPECT_EQ(
        problem("nm, 0\n400, 1.5\n500, 1\n"),
        fmt::format("\"{}\" has the value 1.5 at 400 nm; write values from 0 to 1", folder / "orders.csv"));
    EXPECT_EQ(problemsOfFile(discWith(R"({"file": "orders.csv", "0": 0.5})"), folder / "scene.json"),
              "\"file\" stands beside single orders; keep one or the other");
}

}  // namespace
}  // namespace fringe::scene
