#pragma once

#include "core/identify/cycle/MeasuredCycle.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// Samples of a branch, where many are averaged in time to few.
struct ContactSamples {
    std::vector<double> time;   ///< [s]; empty: not known
    std::vector<double> base;   ///< [m]
    std::vector<double> force;  ///< [N]

    [[nodiscard]] std::size_t size() const noexcept { return base.size(); }
};

/// Averages the samples [from, to) of a branch into at most `bins` about equal groups.
[[nodiscard]] ContactSamples binned(const CycleBranch& branch, std::size_t from, std::size_t to,
                                    std::size_t bins);

/// Slope of the force over the base in the upper half of the forces [N/m].
[[nodiscard]] double contactSlope(const ContactSamples& samples);

}  // namespace asperity
