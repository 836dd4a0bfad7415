#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "tests/core/io/heightmap/MapStatistics.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Small files that once had a wrong size, position or kind, or were not read at all, and their
// right values: afm/cases/CASES.csv, to 2e-6.

namespace asperity::test {

namespace {

constexpr double kTolerance = 2e-6;

/// A row of the table; cells that are empty are not compared.
class Case {
public:
    Case(const ReferenceTable& table, std::size_t row) : table_(table), row_(row) {}

    [[nodiscard]] std::string file() const { return table_.text(row_, "file"); }
    [[nodiscard]] const std::string& text(const std::string& column) const {
        return table_.text(row_, column);
    }

    void expectNear(double value, const std::string& column, double scale) const {
        if (!text(column).empty()) {
            EXPECT_NEAR(value, table_.number(row_, column), kTolerance * std::abs(scale)) << column;
        }
    }
    void expectEqual(double value, const std::string& column) const {
        if (!text(column).empty()) {
            EXPECT_EQ(value, table_.number(row_, column)) << column;
        }
    }
    [[nodiscard]] double number(const std::string& column) const {
        return table_.number(row_, column);
    }

private:
    const ReferenceTable& table_;
    std::size_t row_;
};

void expectRead(const Case& row, const HeightMapFile& file, const std::filesystem::path& path) {
    const std::string& name = row.text("channel");
    const ScanChannel& channel =
        name.empty() ? file.channels.at(file.defaultChannel) : channelNamed(file, path, name);
    const HeightMap& map = channel.map;
    row.expectEqual(map.columns, "width_px");
    row.expectEqual(map.rows, "height_px");
    row.expectNear(map.sizeX(), "xreal_m", row.number("xreal_m"));
    row.expectNear(map.sizeY(), "yreal_m", row.number("yreal_m"));
    if (!row.text("unit").empty()) {
        EXPECT_EQ(channel.unit, row.text("unit"));
    }
    const HeightStatistics statistics = statisticsOf(map);
    const double range = row.number("max") - row.number("min");
    row.expectNear(statistics.lowest, "min", range);
    row.expectNear(statistics.highest, "max", range);
    row.expectNear(channel.originX, "origin_x_m", row.number("origin_x_m"));
    row.expectNear(channel.originY, "origin_y_m", row.number("origin_y_m"));
}

}  // namespace

TEST(Cases, AreReadWithTheirValues) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable table(sharedData("afm/cases/CASES.csv"));
    for (std::size_t i = 0; i < table.rows(); ++i) {
        const Case row(table, i);
        SCOPED_TRACE(row.file());
        const std::filesystem::path path = sharedData("afm/cases/" + row.file());
        ASSERT_NO_THROW(expectRead(row, readHeightMapFile(path), path));
    }
    EXPECT_GE(table.rows(), 15U);
}

}  // namespace asperity::test
