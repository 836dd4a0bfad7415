#pragma once

#include "core/map/MapPlan.h"
#include "core/surface/HeightMap.h"
#include "core/surface/leveling/PlaneFit.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace asperity {

inline constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Relation of a measured map to a predicted one, over the pixels that hold data in both. Values in
/// their unit; NaN: not defined. Standard deviations are those of the pixels (1/n).
struct MapComparison {
    std::size_t pixels = 0;              ///< of the map
    std::size_t compared = 0;            ///< that hold data in both
    std::size_t withoutPrediction = 0;   ///< that the prediction has no data for
    std::size_t withoutMeasurement = 0;  ///< that the measurement has no data for
    double measuredMean = kUndefined;
    double measuredDeviation = kUndefined;
    double predictedMean = kUndefined;
    double predictedDeviation = kUndefined;
    double meanDifference = kUndefined;  ///< of measured minus predicted
    double rmsDifference = kUndefined;   ///< same
    /// Offset of the least-squares line measured = offset + slope * predicted; not defined where
    /// the prediction is constant.
    double offset = kUndefined;
    double slope = kUndefined;
    double rmsResidual = kUndefined;  ///< of the line
    double correlation = kUndefined;  ///< Pearson's; not defined where either map is constant
    /// Share of the measured variance that the line explains, the squared correlation.
    double shareByLine = kUndefined;
    /// The same by the prediction as it is, 1 - var(measured - predicted) / var(measured): below 0
    /// where the prediction makes it worse. Not defined where the measurement is constant.
    double shareAsPredicted = kUndefined;

    /// Returns whether a map varies by no more than rounding.
    [[nodiscard]] bool isMeasuredConstant() const;
    [[nodiscard]] bool isPredictedConstant() const;
    [[nodiscard]] double residual(double measured, double predicted) const {
        return measured - (offset + slope * predicted);
    }
};

/// @param predicted, measured of the same pixels, in the same unit; NaN: no data
/// The line needs at least three compared pixels.
[[nodiscard]] MapComparison compareMaps(std::span<const double> predicted,
                                        std::span<const double> measured);

/// A measured map against a quantity of a plan.
struct ComparedQuantity {
    std::vector<double> predicted;  ///< at the plan's pixels, NaN: no data; without its plane
    std::vector<double> measured;   ///< same, without both planes
    /// Removed from the measured map: that of measured minus predicted. Positions from the region's
    /// lower left corner.
    std::optional<PlaneFit> plane;
    /// Removed from both: that of the predicted map.
    std::optional<PlaneFit> predictedPlane;
    MapComparison numbers;
};

/// Compares a measured map with a quantity of the plan. Height and tilt of a recorded topography
/// are those of the instrument's mounting: heights lose their least-squares planes over the
/// compared pixels first, so that no tilt that the prediction has counts as explained.
/// @param predicted, measured at the plan's pixels, row by row from the top, in the quantity's unit
[[nodiscard]] ComparedQuantity compareQuantity(const MapPlan& plan, MapQuantity quantity,
                                               std::vector<double> predicted,
                                               std::vector<double> measured);

/// Returns whether an instrument may measure the quantity: not flags and counts of the computation,
/// nor uncertainties by model and calibration.
[[nodiscard]] bool isMeasurable(MapQuantity quantity);

/// The quantities of a plan that a measured channel may show: those of its unit; of several, those
/// whose key has the most words of its title. None, one, or several between which only the user can
/// decide.
/// @param unit SI @param title "Adhesion", "HeightSensor"
[[nodiscard]] std::vector<MapQuantity> quantitiesLike(const MapPlan& plan, std::string_view unit,
                                                      std::string_view title);

/// The area that a measured map of this size shows [m]: the plan's region or the whole scan,
/// whichever it fits better; none: neither fits to 2 % of each side.
/// @param scan the whole scan, world frame
[[nodiscard]] std::optional<MapRegion> measuredArea(double width, double height,
                                                    const MapPlan& plan, const MapRegion& scan);

/// A measured map at the centers of a plan's pixels, row by row from the top: bilinear between its
/// own pixel centers, constant beyond the outermost ones; NaN where a pixel that it needs holds no
/// data. Where the centers coincide, a pixel's own value.
/// @param measured values in any unit, NaN or marked where there are no data
/// @param area     that it covers, world [m]
[[nodiscard]] std::vector<double> valuesAt(const MapPlan& plan, const HeightMap& measured,
                                           const MapRegion& area);

}  // namespace asperity
