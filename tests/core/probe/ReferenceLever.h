#pragma once

#include "core/probe/CantileverModes.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace asperity::test {

inline CantileverGeometry leverOfRow(const ReferenceTable& table, std::size_t row) {
    CantileverGeometry lever;
    lever.youngsModulus = table.number(row, "E");
    lever.poissonRatio = table.number(row, "nu");
    lever.length = table.number(row, "l");
    lever.width = table.number(row, "w");
    lever.thickness = table.number(row, "t");
    lever.tipHeight = table.number(row, "h");
    return lever;
}

/// The cantilever of T10 by its name, not tilted.
inline CantileverGeometry referenceLever(const std::string& name) {
    const ReferenceTable table = referenceTable("T10_compliance.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "geom") == name) {
            return leverOfRow(table, row);
        }
    }
    ADD_FAILURE() << "no cantilever " << name;
    return {};
}

/// |actual - expected| at most `tolerance` times |expected|.
inline void expectRelative(double actual, double expected, double tolerance) {
    EXPECT_NEAR(actual, expected, tolerance * std::abs(expected));
}

inline Vector3 vectorOfRow(const ReferenceTable& table, std::size_t row, const std::string& prefix,
                           const std::string& axes = "xyz") {
    return {table.number(row, prefix + axes[0]), table.number(row, prefix + axes[1]),
            table.number(row, prefix + axes[2])};
}

}  // namespace asperity::test
