#pragma once

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// One indentation at which the law is to be solved, all in the units of MaugisPoint.
struct ContactCase {
    double lambda = 0.0;
    double lowContactRadius = 0.0;  ///< below that of the stable state
    double indentation = 0.0;
    double force = 0.0;  ///< the exact one
};

/// Times of SciPy's two nested searches for each case, and their largest error.
struct PeerTiming {
    double nanoseconds = 0.0;  ///< median over the cases
    double error = 0.0;        ///< of the force, relative to its size or to one
};

/// Runs scipy_maugis.py in the style "numpy" or "math"; none where SciPy is not installed.
[[nodiscard]] std::optional<PeerTiming> timeSciPy(const std::string& style,
                                                  const std::vector<ContactCase>& cases);

}  // namespace asperity
