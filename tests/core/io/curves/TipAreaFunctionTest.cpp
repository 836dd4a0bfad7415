#include "core/io/curves/TipAreaFunction.h"

#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::HasSubstr;

std::string refusalOfArea(const std::string& text) {
    const ScratchFolder folder;
    return refusalOf([&] { (void)readTipAreaFunction(folder.write("area.txt", text)); });
}

}  // namespace

TEST(TipAreaFunction, IsReadAsItWasMeasured) {
    ASPERITY_NEEDS_SHARED_DATA();
    const TipAreaFunction tip =
        readTipAreaFunction(sharedData("curves/original/NI_08_check_0003_arfun.txt"));
    ASSERT_EQ(tip.depth.size(), 570U);
    EXPECT_EQ(tip.area.front(), 0.0);
    EXPECT_DOUBLE_EQ(tip.depth[1], 0.613582546321e-9);
    EXPECT_DOUBLE_EQ(tip.area.back(), 375644.816005e-18);
}

TEST(TipAreaFunction, MayNameItsUnits) {
    const ScratchFolder folder;
    const TipAreaFunction tip = readTipAreaFunction(
        folder.write("area.csv", "# a tip\ndepth (um),area (um^2)\n0,0\n0.1,0.5\n"));
    EXPECT_DOUBLE_EQ(tip.depth[1], 0.1e-6);
    EXPECT_DOUBLE_EQ(tip.area[1], 0.5e-12);
}

TEST(TipAreaFunction, IsRefusedInWords) {
    EXPECT_THAT(refusalOfArea("0 0\n1 x\n"), HasSubstr("line 2: expected two numbers"));
    EXPECT_THAT(refusalOfArea("0 0\n1 5\n1 6\n"), HasSubstr("line 3: the depth must rise"));
    EXPECT_THAT(refusalOfArea("0 0\n1 5\n2 4\n"), HasSubstr("the area must not fall"));
    EXPECT_THAT(refusalOfArea("0 -1\n1 5\n"), HasSubstr("0 or more"));
    EXPECT_THAT(refusalOfArea("0 0\n"), HasSubstr("two points"));
}

}  // namespace asperity::test
