#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Files that hold no image are refused with what they are.

namespace asperity::test {

namespace {

using testing::HasSubstr;
using testing::Not;

std::string refusalOfCurves(const std::string& bytes) {
    return refusalOf([&] { (void)readHeightMapBytes(bytes, "curve.dat"); });
}

}  // namespace

TEST(ForceCurveFiles, AreNamedByTheirProgram) {
    const struct {
        std::string bytes;
        const char* program;
    } files[] = {
        {"# xPosition: 1\n# columns: height vDeflection\n# fancyNames: \"a\"\n1 2 3\n2 3 4\n",
         "JPK"},
        {"Calc_Ramp_Ex_nm\tCalc_Ramp_Rt_nm\tDefl_V_Ex\tDefl_V_Rt\n1\t2\t3\t4\n", "NanoScope"},
        {"\"\\*Force file list\"\r\n1 2 3 4\r\n", "NanoScope"},
        {"Experiment\tZ spectroscopy\t\r\nX (m)\t1\r\n\r\n[DATA]\r\n1\t2\r\n", "Nanonis"},
        {"PS-PPT/v1\n", "Park"},
    };
    for (const auto& file : files) {
        EXPECT_THAT(
            refusalOfCurves(file.bytes),
            AllOf(HasSubstr("curve.dat: "), HasSubstr("force curves"), HasSubstr(file.program)))
            << file.bytes;
    }
}

TEST(ForceCurveFiles, AreNotAmongTheFormatsThatCanBeRead) {
    EXPECT_THAT(refusalOfCurves("nothing known"), Not(HasSubstr("force curves")));
}

}  // namespace asperity::test
