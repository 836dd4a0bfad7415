#pragma once

#include "core/Progress.h"
#include "core/studies/extremes/BenchHold.h"
#include "core/studies/extremes/ExtremesGrid.h"
#include "core/studies/extremes/ExtremesRegion.h"

#include <string>
#include <vector>

namespace asperity {

/// Results of a part of the study.
struct ExtremesFindings {
    std::vector<ExtremesRegion> regions;
    std::vector<HoldOutcome> holds;
    long states = 0;   ///< of the grid, each once however many models are asked
    long defects = 0;  ///< states that no answer may have: a value that is not finite, no balance
    /// The first of them in each region, one sentence each, so that it can be repeated.
    std::vector<std::string> examples;

    /// Counts one more of them. @param sentence says what state it is and what is wrong
    void addDefect(const std::string& sentence);

    void add(ExtremesFindings&& other);
    /// Answers of all models and settings to the grid's states and to those out of range.
    [[nodiscard]] long answers() const noexcept;
};

/// Evaluates every state of the grid on the virtual clock, on as many threads as there are cores;
/// the same grid gives the same findings. @param progress may be null @throw Canceled
[[nodiscard]] ExtremesFindings studyExtremes(const ExtremesGrid& grid,
                                             Progress* progress = nullptr);

}  // namespace asperity
