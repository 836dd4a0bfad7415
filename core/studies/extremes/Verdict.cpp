#include "core/studies/extremes/Verdict.h"

#include <algorithm>
#include <cmath>

namespace asperity {

Verdict verdictOnError(double error) noexcept {
    if (error <= kExactWithin) {
        return Verdict::Exact;
    }
    return error <= kValidWithin ? Verdict::Valid : Verdict::Off;
}

double relativeError(double value, double reference, double unit) noexcept {
    const double size = std::max({std::abs(value), std::abs(reference), unit});
    return size > 0.0 ? std::abs(value - reference) / size : 0.0;
}

}  // namespace asperity
