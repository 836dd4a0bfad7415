#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/support/ReferenceTable.h"
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

/// Frames of these types, of 10 bytes each.
std::string ntMdtFile(const std::vector<std::uint16_t>& types) {
    std::string bytes("\x01\xB0\x93\xFF", 4);
    bytes.append(8, '\0');
    appendLittleEndian(bytes, static_cast<std::uint16_t>(types.size() - 1));
    bytes.append(19, '\0');
    for (const std::uint16_t type : types) {
        appendLittleEndian(bytes, std::uint32_t{10});
        appendLittleEndian(bytes, type);
        bytes.append(4, '\0');
    }
    return bytes;
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
        {"Force-Distance Curve\r\nFile Format:\t3\r\n\r\n"
         "Extend Z-Sense(nm),Extend T-B(V),Retract Z-Sense(nm),Retract T-B(V)\r\n1,2,3,4\r\n",
         "AFM Workshop"},
        {"# {\n#   \"imaging mode\": \"force-distance\"\n# }\n# force\ttip position\n1\t2\n2\t3\n",
         "afmformats"},
        {"# a curve\nsegment,time_s,base_m,deflection_m,force_N\n0:approach,0,1,2,3\n", "Asperity"},
        {ntMdtFile({1, 1}), "NT-MDT"},
    };
    for (const auto& file : files) {
        EXPECT_THAT(
            refusalOfCurves(file.bytes),
            AllOf(HasSubstr("curve.dat: "), HasSubstr("force curves"), HasSubstr(file.program)))
            << file.bytes;
    }
}

TEST(ForceCurveFiles, OfNtMdtAreThoseWithoutAnImage) {
    EXPECT_THAT(refusalOfCurves(ntMdtFile({1, 106})), Not(HasSubstr("force curves")));
    EXPECT_THAT(refusalOfCurves(ntMdtFile({1, 1}).substr(0, 40)), Not(HasSubstr("force curves")));
}

TEST(ForceCurveFiles, ThreeColumnsOfWhichTheFirstRisesEvenlyAreACurve) {
    std::string text;
    for (int i = 0; i < 30; ++i) {
        text += std::to_string(i) + ",5\t" + std::to_string(7 * i % 11) + ",1\t" +
                std::to_string(5 * i % 13) + ",2\r\n";
    }
    EXPECT_THAT(refusalOfCurves(text), HasSubstr("force curves"));
}

TEST(ForceCurveFiles, RealOnesAreNamedAsWhatTheyAre) {
    ASPERITY_NEEDS_SHARED_DATA();
    std::size_t named = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sharedData("curves/original"))) {
        const std::string name = entry.path().filename().string();
        const std::string refusal = refusalOf([&] { (void)readHeightMapFile(entry.path(), {}); });
        if (refusal.empty() || name.ends_with(".zip")) {
            continue;  // it holds an image, too; a zip archive of anything
        }
        EXPECT_THAT(refusal, HasSubstr("force curve")) << name;
        ++named;
    }
    EXPECT_GE(named, 15U);
}

TEST(ForceCurveFiles, AreNotAmongTheFormatsThatCanBeRead) {
    EXPECT_THAT(refusalOfCurves("nothing known"), Not(HasSubstr("force curves")));
}

}  // namespace asperity::test
