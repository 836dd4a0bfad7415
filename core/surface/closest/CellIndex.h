#pragma once

namespace asperity {

/// Row and column of a spline cell, see CellBounds.
struct CellIndex {
    int row = 0;
    int column = 0;
};

}  // namespace asperity
