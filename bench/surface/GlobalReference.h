#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"

#include <vector>

namespace asperity {

/// Thoroughness of the reference.
struct ReferenceEffort {
    int samplesPerCell = 5;  ///< along each axis, both borders of a cell among them
    bool skipsCells = true;  ///< leaves out cells whose control heights keep them too far away
};

/// The truth by brute force: every cell of the spline in reach is sampled densely, and every sample
/// below its neighbors is brought down to its minimum.
class GlobalReference {
public:
    struct Nearest {
        Vector2 position = Vector2::Zero();  ///< world x, y [m]
        double distance = 0.0;               ///< [m], > 0
    };

    explicit GlobalReference(const BSplineSurface& surface, ReferenceEffort effort = {});

    [[nodiscard]] Nearest nearest(const Vector3& query) const;

private:
    /// Heights that a cell stays between [m].
    struct HeightRange {
        double low = 0.0;
        double high = 0.0;
    };
    /// A cell's extent along one axis, world [m].
    struct Extent {
        double low = 0.0;
        double high = 0.0;
    };
    /// Cells along one axis: [first, last].
    struct CellRange {
        int first = 0;
        int last = 0;
    };

    [[nodiscard]] HeightRange rangeOf(int row, int column) const;
    [[nodiscard]] static Extent extentOf(int cell, int cells, double pitch);
    [[nodiscard]] static CellRange cellsWithin(double center, double reach, int cells,
                                               double pitch);
    [[nodiscard]] double leastDistance(const Vector3& query, int row, int column) const;
    void searchCell(const Vector3& query, int row, int column, Nearest& best) const;
    void polish(const Vector3& query, const Vector2& start, Nearest& best) const;

    const BSplineSurface& surface_;
    ReferenceEffort effort_;
    int columns_;  ///< of cells
    int rows_;
    std::vector<HeightRange> ranges_;
};

}  // namespace asperity
