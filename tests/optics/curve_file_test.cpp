#include "optics/curve_file.hpp"

#include <gtest/gtest.h>

namespace fringe::optics {
namespace {

TEST(CurveFile, HoldsWavelengthsAndValues) {
    const Curve curve =
        parseCurve("# a lamp\nwavelength_nm,power\r\n380,0\n\n 450.5 ,\t1.25e-3\r\n# end\n780,2");
    ASSERT_EQ(curve.size(), 3u);
    EXPECT_EQ(curve[0].wavelength_nm, 380.0);
    EXPECT_EQ(curve[0].value, 0.0);
    EXPECT_EQ(curve[1].wavelength_nm, 450.5);
    EXPECT_EQ(curve[1].value, 1.25e-3);
    EXPECT_EQ(curve[2].wavelength_nm, 780.0);
    EXPECT_EQ(curve[2].value, 2.0);
}

TEST(CurveFile, NeedsNoNamesOfColumns) {
    EXPECT_EQ(parseCurve("380,1\n780,1\n").size(), 2u);
}

struct Mistake {
    const char* text;
    std::size_t line;
    const char* message;
};

TEST(CurveFile, SaysWhereItIsWrongAndWhatIsRight) {
    constexpr const char* kNumbers = "must be 2 finite numbers with commas between them, as in \"550,0.25\"";
    const Mistake mistakes[] = {
        {"380,1\n400;1\n780,1", 2, kNumbers},
        {"nm,value\n\n# x\n380,1,5\n780,1", 4, kNumbers},
        {"380,1\n400,\n780,1", 2, kNumbers},
        {"380,1\n400\n780,1", 2, kNumbers},
        {"380,1\n400,1x\n780,1", 2, kNumbers},
        {"380,1\n400,inf\n780,1", 2, kNumbers},
        {"380,nan\n780,1", 1, kNumbers},
        {"nm,value\nnm,value\n380,1\n780,1", 2, kNumbers},
        {"380,1\n400,1\n400,1", 3, "wavelength 400 nm must be longer than the one before, 400 nm"},
        {"380,1\n400,1\n390,1", 3, "wavelength 390 nm must be longer than the one before, 400 nm"},
        {"380,1\n400,-0.5\n780,1", 2, "value -0.5 must be at least 0"},
        {"nm,value\n550,1\n# no more\n", 2, "a curve needs two rows or more of wavelength_nm,value"},
        {"", 1, "a curve needs two rows or more of wavelength_nm,value"},
        {"0.38,1\n0.78,1", 2, "no part of 0.38 to 0.78 nm is visible, which is 380 to 780 nm"},
        {"900,1\n1000,1", 2, "no part of 900 to 1000 nm is visible, which is 380 to 780 nm"},
    };
    for (const Mistake& mistake : mistakes) {
        try {
            parseCurve(mistake.text);
            ADD_FAILURE() << "accepted:\n" << mistake.text;
        } catch (const CurveFileError& error) {
            EXPECT_EQ(error.line(), mistake.line) << mistake.text;
            EXPECT_STREQ(error.what(), mistake.message) << mistake.text;
        }
    }
}

TEST(CurveFile, TablesMayHaveMoreColumns) {
    const std::vector<TableRow> rows = readTable("l,x,y,z\n1,2,3,4\n5,6,7,8", 4);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[1].line, 3u);
    EXPECT_EQ(rows[1].values[0], 5.0);
    EXPECT_EQ(rows[1].values[3], 8.0);
    EXPECT_THROW(readTable("1,2,3,4,5", 4), CurveFileError);
}

}  // namespace
}  // namespace fringe::optics
