#pragma once

#include "bench/BenchRows.h"
#include "bench/scaling/PowerLaw.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Cost of one thing as the work grows.
struct ScalingCurve {
    std::string name;           ///< "closest point, median"
    double maxSlope = 0.0;      ///< goal: the exponent of the power law is at most this
    std::vector<double> times;  ///< one for each work of the sweep [s]
};

/// One kind of work in several amounts.
struct ScalingSweep {
    std::string what;           ///< "map pixels"
    std::string unit;           ///< of the works: "million"
    std::vector<double> works;  ///< rising
    std::vector<std::string>
        labels;  ///< of the works, on the first curve of the figure; empty: none
    std::vector<ScalingCurve> curves;
    std::size_t queries = 0;    ///< of closest points in all works
    std::size_t certified = 0;  ///< of these
};

/// Returns how the curve's times grow with the sweep's works. @throw Error as fitPowerLaw()
[[nodiscard]] PowerLaw growthOf(const ScalingSweep& sweep, const ScalingCurve& curve);

/// The slope of each curve beside its goal, and the share of proven closest points in all sweeps.
[[nodiscard]] std::vector<BenchRow> scalingRows(std::span<const ScalingSweep> sweeps);

}  // namespace asperity
