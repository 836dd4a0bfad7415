#pragma once

#include "core/io/curves/CurveColumns.h"
#include "core/io/curves/StoredCurves.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

class ByteSource;
class TextLines;

/// Columns of one branch of a table by their index; -1: there is none.
struct BranchColumns {
    int time = -1;
    int distance = -1;
    int signal = -1;
    int deflection = -1;
    int force = -1;

    /// Returns whether it has a distance and anything of the lever.
    [[nodiscard]] bool isWhole() const {
        return distance >= 0 && (signal >= 0 || deflection >= 0 || force >= 0);
    }
};

/// Which column of a table holds what.
struct CurveTable {
    std::vector<CurveColumn> columns;
    BranchColumns first;   ///< of all rows, or of the approach
    BranchColumns second;  ///< of the retract, where it has columns of its own
    int segment = -1;
    std::vector<int> numbers;  ///< columns that hold numbers, from 1 on; of tables without titles
};

/// The table below a line of titles; none where the line names no distance and nothing of the
/// lever.
[[nodiscard]] std::optional<CurveTable> titledTable(const std::vector<std::string>& titles);
/// The table whose columns a user names.
[[nodiscard]] CurveTable givenTable(const std::vector<GivenColumn>& columns);

/// Returns whether a text has a line of titles near its begin.
[[nodiscard]] bool hasCurveTitles(const ByteSource& bytes);

/// Reads the curve of a text. @param table without titles; empty: below its line of titles
/// @throw InputError with the line, and what was expected there
[[nodiscard]] CurveContents readTextCurve(const ByteSource& bytes, const CurveReadOptions& options,
                                          const std::optional<CurveTable>& table = std::nullopt);

}  // namespace asperity
