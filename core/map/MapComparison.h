#pragma once

#include "core/map/MapPlan.h"
#include "core/surface/leveling/PlaneFit.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace asperity {

inline constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// How a measured map relates to a predicted one, over the pixels that hold data in both. Values
/// in their unit; NaN: not defined. Standard deviations are those of the pixels (1/n).
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
    double rmsDifference = kUndefined;   ///< likewise
    /// Of the least-squares line measured = offset + slope * predicted; not defined where the
    /// prediction is constant.
    double offset = kUndefined;
    double slope = kUndefined;
    double rmsResidual = kUndefined;  ///< of the line
    double correlation = kUndefined;  ///< Pearson's; not defined where either map is constant
    /// Share of the measured variance that the line explains, the squared correlation.
    double shareByLine = kUndefined;
    /// The same by the prediction as it is, 1 - var(measured - predicted) / var(measured): below 0
    /// where the prediction makes it worse. Not defined where the measurement is constant.
    double shareAsPredicted = kUndefined;

    /// Whether a map varies by no more than rounding.
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
    std::vector<double> measured;   ///< likewise, without both planes
    /// Removed from the measured map: that of measured minus predicted. Places from the region's
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

}  // namespace asperity
