#pragma once

#include "core/experiment/Study.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// One trial before it is done.
struct PlannedTrial {
    int number = 0;            ///< in the study, from 1
    int participant = 0;       ///< from 1
    std::size_t task = 0;      ///< of Study::tasks
    std::size_t material = 0;  ///< of Study::materials
    std::size_t lever = 0;     ///< of Study::levers
    std::size_t target = 0;    ///< of Study::targets
    int repeat = 0;            ///< from 1
    int attempt = 1;           ///< one more after each that a fault ended or that was struck out
    double height = 0.0;       ///< of the target above the surface at rest; < 0: below [m]
    std::uint64_t seed = 0;    ///< of all that is random in the trial

    bool operator==(const PlannedTrial&) const = default;
};

/// The same trial once more, with other random numbers.
[[nodiscard]] PlannedTrial again(PlannedTrial trial);

/// Row of a Latin square in which every condition follows every other one equally often; an odd
/// number of conditions needs two squares, 2 count rows.
/// Source: Williams (1949), Australian Journal of Scientific Research A 2, 149.
[[nodiscard]] std::vector<std::size_t> balancedOrder(std::size_t count, std::size_t row);

/// All trials of the participants, one participant after the other: repeats; in each the tasks; in
/// each task the levers; with each lever the materials, so that the material changes after each
/// target. Orders are rows of balanced squares, the next one for each participant and repeat, from
/// rows that the seed draws, over conditions that it has shuffled.
/// The trials of a participant do not depend on how many others there are.
[[nodiscard]] std::vector<PlannedTrial> planTrials(const Study& study, int participants,
                                                   std::uint64_t seed);

}  // namespace asperity
