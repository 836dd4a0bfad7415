#include "bench/scaling/ScalingSweep.h"

#include <optional>

namespace asperity {

namespace {

BenchRow certifiedRow(std::span<const ScalingSweep> sweeps) {
    std::size_t queries = 0;
    std::size_t certified = 0;
    for (const ScalingSweep& sweep : sweeps) {
        queries += sweep.queries;
        certified += sweep.certified;
    }
    std::optional<double> share;
    if (queries > 0) {
        share = 100.0 * static_cast<double>(certified) / static_cast<double>(queries);
    }
    return {.name = "scaling, " + std::to_string(queries) + " queries: certified",
            .value = share,
            .unit = "%",
            .goal = 100.0};
}

}  // namespace

PowerLaw growthOf(const ScalingSweep& sweep, const ScalingCurve& curve) {
    return fitPowerLaw(sweep.works, curve.times);
}

std::vector<BenchRow> scalingRows(std::span<const ScalingSweep> sweeps) {
    std::vector<BenchRow> rows;
    for (const ScalingSweep& sweep : sweeps) {
        for (const ScalingCurve& curve : sweep.curves) {
            rows.push_back({.name = "slope against " + sweep.what + ": " + curve.name,
                            .value = growthOf(sweep, curve).exponent,
                            .unit = "",
                            .goal = curve.maxSlope,
                            .kind = GoalKind::AtMost});
        }
    }
    rows.push_back(certifiedRow(sweeps));
    return rows;
}

}  // namespace asperity
