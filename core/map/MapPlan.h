#pragma once

#include "core/ShareOut.h"
#include "core/Vector.h"
#include "core/map/JumpSearch.h"
#include "core/map/MapQuantity.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// A part of the scan, world frame [m].
struct MapRegion {
    double left = 0.0;
    double bottom = 0.0;
    double right = 0.0;
    double top = 0.0;

    bool operator==(const MapRegion&) const = default;
};

/// Pixels of a map.
struct MapGrid {
    int columns = 0;
    int rows = 0;

    bool operator==(const MapGrid&) const = default;
};

/// Request for a map; empty: planMap() decides.
struct MapRequest {
    MapMode mode = MapMode::Approach;
    std::optional<MapGrid> grid = {};          ///< none: the scan's pixels in the region
    std::optional<MapRegion> region = {};      ///< none: the whole scan
    std::optional<double> setpoint = {};       ///< [N]; none: the scene's
    std::vector<std::string> quantities = {};  ///< keys; none: all of the mode, but on request
    bool deviations = false;  ///< standard deviations by model and calibration, too
    bool truth = false;       ///< of the simulated true instrument, instead of the believed model
};

/// The force along z at which an approach ends [N]: the one asked for, else the scene's.
/// @throw Error where it is out of range
[[nodiscard]] double setpointOn(const Scene& scene, const std::optional<double>& wanted);

/// A map to be computed, complete.
struct MapPlan {
    MapMode mode = MapMode::Approach;
    MapGrid grid;
    MapRegion region;
    double setpoint = 0.0;                ///< force along z [N]
    std::vector<MapQuantity> quantities;  ///< in the order of their table
    bool truth = false;

    [[nodiscard]] double pitchX() const { return (region.right - region.left) / grid.columns; }
    [[nodiscard]] double pitchY() const { return (region.top - region.bottom) / grid.rows; }
    /// The middle of a pixel, row 0 at the top, world [m].
    [[nodiscard]] Vector2 position(int row, int column) const;
};

/// The plan of a request on a scene.
/// @throw Error in one sentence where a quantity is none of the mode, the grid has no pixel or more
/// than 65536 along a side, the region lies outside the scan or is empty, or the setpoint is out of
/// range
[[nodiscard]] MapPlan planMap(const Scene& scene, const MapRequest& request);

/// One row of a map, 0 at the top: for each quantity of the plan, in its order, a value for each
/// column, in the quantity's unit; NaN where there is none. It depends on nothing but its
/// arguments.
/// @throw Canceled
[[nodiscard]] std::vector<double> mapRow(const MapInstrument& instrument, const MapPlan& plan,
                                         int row, const CancelCheck& check = {});

/// All quantities of mode `contact` in one row of a map: the tip engages at the left end, is drawn
/// to the right end (trace) and back (retrace), while the base keeps the force along z that the
/// bending shows at the setpoint, as an AFM does; friction has its full direction. It depends on
/// nothing else. Where the tip is lost it engages again at the next pixel.
/// @throw Canceled
[[nodiscard]] std::vector<MapValues>
rasterLine(const MapInstrument& instrument, const MapPlan& plan, int row, const CancelCheck& check);

}  // namespace asperity
