#include "ui/plot/CopyablePlot.h"
#include "ui/shell/RunPanel.h"

#include <gtest/gtest.h>

#include <limits>

namespace asperity {
namespace {

TEST(PlotTable, IsTabSeparatedWithOneLineOfHeaders) {
    PlotTable table;
    EXPECT_TRUE(table.isEmpty());
    table.add(QStringLiteral("time [s]"), std::vector<double>{0.1, 2.0});
    table.add(QStringLiteral("Fz [N]"),
              std::vector<double>{-1.5e-9, std::numeric_limits<double>::quiet_NaN(), 3.0});
    table.add(QStringLiteral("name"), QStringList{QStringLiteral("one\ttwo\nthree")});
    EXPECT_EQ(table.tabSeparated(), QStringLiteral("time [s]\tFz [N]\tname\n"
                                                   "0.1\t-1.5e-09\tone two three\n"
                                                   "2\t\t\n"
                                                   "\t3\t\n"));
}

TEST(PlotTable, NumbersComeBackToTheSameBits) {
    for (const double value : {1.0 / 3.0, 6.02214076e23, -4.9406564584124654e-324}) {
        EXPECT_EQ(numberCell(value).toDouble(), value);
    }
    EXPECT_EQ(numberCell(std::numeric_limits<double>::infinity()), QString());
}

TEST(ShownNumbers, AreListedWithStandardDeviationAndUnit) {
    const ShownNumbers numbers{{QStringLiteral("Fz"), 5e-9, 1e-11, QStringLiteral("N"), 5e-10},
                               {QStringLiteral("ticks"), 12.0, {}, {}}};
    EXPECT_EQ(
        tabSeparated(numbers),
        QStringLiteral("name\tvalue\tstandard deviation by noise\tby model and calibration\tunit\n"
                       "Fz\t5e-09\t1e-11\t5e-10\tN\n"
                       "ticks\t12\t\t\t\n"));
}

}  // namespace
}  // namespace asperity
