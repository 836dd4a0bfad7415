#pragma once

namespace asperity {

/// A rectangle of pixels of a scan.
struct PixelRectangle {
    int column = 0;   ///< its left column; 0 is that of the scan
    int row = 0;      ///< its top row; 0 is that of the scan
    int columns = 0;  ///< how many
    int rows = 0;     ///< how many

    /// Whether it holds a pixel, and none outside a scan of this size.
    [[nodiscard]] constexpr bool liesIn(int scanColumns, int scanRows) const {
        return column >= 0 && row >= 0 && columns > 0 && rows > 0 &&
               columns <= scanColumns - column && rows <= scanRows - row;
    }
    bool operator==(const PixelRectangle&) const = default;
};

}  // namespace asperity
