#include "bench/scaling/ScalingTable.h"

#include <cstddef>
#include <cstdio>

namespace asperity {

void printTable(const ScalingSweep& sweep) {
    std::printf("%s [%s]; times in microseconds\n%14s", sweep.what.c_str(), sweep.unit.c_str(), "");
    for (const ScalingCurve& curve : sweep.curves) {
        std::printf("  %38s", curve.name.c_str());
    }
    for (std::size_t i = 0; i < sweep.works.size(); ++i) {
        std::printf("\n%14.8g", sweep.works[i]);
        for (const ScalingCurve& curve : sweep.curves) {
            std::printf("  %38.2f", 1e6 * curve.times[i]);
        }
    }
    std::printf("\n%14s", "slope");
    for (const ScalingCurve& curve : sweep.curves) {
        std::printf("  %38.3f", growthOf(sweep, curve).exponent);
    }
    std::printf("\ncertified: %zu of %zu\n\n", sweep.certified, sweep.queries);
    std::fflush(stdout);
}

}  // namespace asperity
