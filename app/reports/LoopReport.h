#pragma once

#include "app/reports/AlternatingBlocks.h"

#include <string>
#include <vector>

namespace asperity {

/// How often one view was drawn.
struct ViewRate {
    std::string view;
    double framesPerSecond = 0.0;
};

/// What `asperity loop` measured. Times of fetching and writing are those of a processor.
struct LoopReport {
    double rate = 0.0;      ///< asked for [Hz]
    double duration = 0.0;  ///< of loop and bare loop together, asked for [s]
    double elapsed = 0.0;   ///< the same, as it was [s]
    LoopStatistics statistics;
    const AlternatingBlocks& blocks;
    double fetchTime = 0.0;       ///< to fetch one tick, into the black box too [s]
    double writingTime = 0.0;     ///< to write one tick into a recording [s]; 0: there is none
    std::vector<ViewRate> views;  ///< empty: without a window
};

/// As one JSON object; times in seconds.
[[nodiscard]] std::string loopReportJson(const LoopReport& report);

/// As a few lines for people.
[[nodiscard]] std::string loopReportText(const LoopReport& report);

}  // namespace asperity
