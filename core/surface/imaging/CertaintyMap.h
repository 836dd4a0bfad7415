#pragma once

#include "core/surface/HeightMap.h"

#include <cstdint>
#include <vector>

namespace asperity {

/// The pixels of a scan that the tip which recorded it has certainly touched: there the scan proves
/// the height of the surface; see TipErosion.h. Immutable, safe to read from any thread.
class CertaintyMap {
public:
    /// Of a scan whose tip is not known: nothing can be said to be uncertain.
    CertaintyMap() = default;
    /// @param map of the same pixels
    /// @param certain rows x columns, 1 where certain; row 0 is the top row
    template <class Heights>
    CertaintyMap(const BasicHeightMap<Heights>& map, const std::vector<std::uint8_t>& certain)
        : columns_(map.columns)
        , rows_(map.rows)
        , pitchX_(map.pitchX)
        , pitchY_(map.pitchY)
        , certain_(certain.begin(), certain.end()) {}

    [[nodiscard]] bool isKnown() const noexcept { return !certain_.empty(); }
    /// Whether the imaging tip did not certainly touch the pixel at world (x, y) [m]; a place
    /// outside the scan counts as the nearest one inside.
    [[nodiscard]] bool isUncertain(double x, double y) const noexcept;
    /// Part of all pixels that is certain.
    [[nodiscard]] double certainShare() const noexcept;

private:
    int columns_ = 0;
    int rows_ = 0;
    double pitchX_ = 0.0;  ///< [m]
    double pitchY_ = 0.0;  ///< [m]
    PixelMask certain_;
};

}  // namespace asperity
