#include "scene/quantity.hpp"

#include <gtest/gtest.h>
#include <json/reader.h>

#include <numbers>
#include <regex>

#include "scene/parse.hpp"

namespace fringe::scene {
namespace {

TEST(Quantity, EveryUnitHasItsSiValue) {
    EXPECT_EQ(unitInSi("m", Dimension::length), 1.0);
    EXPECT_EQ(unitInSi("cm", Dimension::length), 1e-2);
    EXPECT_EQ(unitInSi("mm", Dimension::length), 1e-3);
    EXPECT_EQ(unitInSi("um", Dimension::length), 1e-6);
    EXPECT_EQ(unitInSi("nm", Dimension::length), 1e-9);
    EXPECT_EQ(unitInSi("deg", Dimension::angle), std::numbers::pi / 180);
    EXPECT_EQ(unitInSi("rad", Dimension::angle), 1.0);
    EXPECT_EQ(unitInSi("mrad", Dimension::angle), 1e-3);
    EXPECT_EQ(unitInSi("W", Dimension::power), 1.0);
    EXPECT_EQ(unitInSi("mW", Dimension::power), 1e-3);
    EXPECT_EQ(unitInSi("uW", Dimension::power), 1e-6);
    EXPECT_EQ(unitInSi("kW", Dimension::power), 1e3);
    EXPECT_EQ(unitInSi("W/m^2", Dimension::irradiance), 1.0);
    EXPECT_EQ(unitInSi("mW/cm^2", Dimension::irradiance), 10.0);
    EXPECT_EQ(unitInSi("W/m^2/sr", Dimension::radiance), 1.0);
    EXPECT_EQ(unitInSi("K", Dimension::temperature), 1.0);
}

TEST(Quantity, BothMicroSignsAreTheLetterU) {
    EXPECT_EQ(unitInSi("\u00b5m", Dimension::length), 1e-6);
    EXPECT_EQ(unitInSi("\u03bcm", Dimension::length), 1e-6);
    EXPECT_EQ(unitInSi("\u00b5W", Dimension::power), 1e-6);
    EXPECT_FALSE(unitInSi("\u00b5", Dimension::length));
}

TEST(Quantity, UnitsOfOtherDimensionsDoNotCount) {
    EXPECT_FALSE(unitInSi("mW", Dimension::length));
    EXPECT_FALSE(unitInSi("m", Dimension::power));
    EXPECT_FALSE(unitInSi("", Dimension::length));
    EXPECT_FALSE(unitInSi("M", Dimension::length));
}

TEST(Quantity, NumberAndUnitAreSplit) {
    EXPECT_EQ(splitQuantity("1.6 um")->number, 1.6);
    EXPECT_EQ(splitQuantity("1.6 um")->unit, "um");
    EXPECT_EQ(splitQuantity("  .5e-3   m ")->number, 0.5e-3);
    EXPECT_EQ(splitQuantity("  .5e-3   m ")->unit, "m");
    EXPECT_EQ(splitQuantity("5.mW")->number, 5.0);
    EXPECT_EQ(splitQuantity("-5")->number, -5.0);
    EXPECT_EQ(splitQuantity("-5")->unit, "");
}

TEST(Quantity, WhatIsNoFiniteDecimalNumberIsRefused) {
    for (const char* text :
         {"", " ", ".", "-", "um", "inf m", "nan m", "infinity", "1e999 m", "+1 m", ". m"}) {
        EXPECT_FALSE(splitQuantity(text)) << text;
    }
}

// The schema's patterns are for editors, the parser is for Fringe: what one takes the other must take.
TEST(Quantity, PatternsOfTheSchemaAgreeWithTheParser) {
    Json::Value schema;
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder{}.newCharReader());
    ASSERT_TRUE(
        reader->parse(schemaText().data(), schemaText().data() + schemaText().size(), &schema, nullptr));
    struct Definition {
        std::string name;
        Dimension dimension;
        bool mayBeNegative;
    };
    for (const auto& [name, dimension, mayBeNegative] : std::vector<Definition>{
             {"any_length", Dimension::length, false},
             {"offset", Dimension::length, true},
             {"angle", Dimension::angle, false},
             {"power", Dimension::power, false},
             {"irradiance", Dimension::irradiance, false},
             {"radiance", Dimension::radiance, false},
             {"temperature", Dimension::temperature, false},
         }) {
        const std::regex pattern(schema["$defs"][name]["pattern"].asString());
        for (const std::string number : {"1", "1.5", "1.", ".5", "1e3", "1E-3", "1.5e+3", " 1", "", ".", "e3",
                                         "1e", "inf", "-1", "-.5", "- 1", "-", "--1", "+1"}) {
            if (number.starts_with('-') && !mayBeNegative) continue;  // is parsed, and refused by the range
            for (const std::string unit :
                 {"m",   "cm",    "mm",      "um",       "nm",  "\u00b5m", "\u03bcm", "km",      "K",
                  "deg", "rad",   "mrad",    "W",        "mW",  "uW",      "\u00b5W", "\u03bcW", "kW",
                  "MW",  "W/m^2", "mW/cm^2", "W/m^2/sr", "W/m", "",        "e"}) {
                for (const std::string gap : {"", " ", "  ", "\t"}) {
                    const std::string text = number + gap + unit;
                    const std::optional<QuantityText> parts = splitQuantity(text);
                    const bool parsed = parts && unitInSi(parts->unit, dimension);
                    EXPECT_EQ(std::regex_match(text, pattern), parsed) << name << ": '" << text << "'";
                }
            }
        }
    }
}

}  // namespace
}  // namespace fringe::scene
