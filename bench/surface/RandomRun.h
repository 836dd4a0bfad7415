#pragma once

#include "bench/surface/SearchWork.h"

#include <cstddef>
#include <cstdint>

namespace asperity {

/// Results of the product with tips anywhere, asked without a start.
struct RandomResult {
    std::string name;
    double referenceDoubt = 0.0;  ///< how far the reference may be off [m]
    std::size_t queries = 0;
    std::size_t wrong = 0;
    double worst = 0.0;  ///< distance above the reference [m]
    double below = 0.0;  ///< distance below the reference: an error of the reference [m]
    std::size_t certified = 0;
    std::size_t certifiedWrong = 0;
    std::size_t restarted = 0;  ///< queries that were asked again from other starts
    std::size_t different = 0;  ///< of these: some start led to another closest point
    std::size_t tied = 0;       ///< of the different: all closest points are equally near
};

/// Ten starts for one query in a hundred: half of them around the tip, half anywhere on the scan.
[[nodiscard]] RandomResult runRandom(const SearchWork& work, std::uint64_t seed);

}  // namespace asperity
