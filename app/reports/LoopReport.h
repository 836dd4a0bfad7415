#pragma once

#include "core/haptics/HapticLoop.h"
#include "core/realtime/PacedThread.h"

#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// The loop beside a bare one of the same policy and rate that does nothing, in turns: what the
/// machine does to both falls out of their ratio.
class AlternatingBlocks {
public:
    static constexpr double kBlock = 1.0;  ///< length of a turn [s]

    AlternatingBlocks(HapticLoop& loop, double rate);
    ~AlternatingBlocks();
    AlternatingBlocks(const AlternatingBlocks&) = delete;
    AlternatingBlocks& operator=(const AlternatingBlocks&) = delete;

    /// Ends a block that is due and begins the next; call it some fifty times a second.
    void poll();
    /// Ends the present block; one that is not whole does not count.
    void finish();

    [[nodiscard]] std::size_t pairs() const noexcept { return bareP99_.size(); }
    /// Median over blocks of the p99 lateness, ours over the bare loop's; 0: no pair yet.
    [[nodiscard]] double medianP99Ratio() const;
    [[nodiscard]] const LoopTimes& own() const noexcept { return own_; }
    [[nodiscard]] const LatencyHistogram& bare() const noexcept { return bare_; }
    [[nodiscard]] long bareSkipped() const noexcept { return bareSkipped_; }

private:
    struct BareLoop;

    [[nodiscard]] bool blockIsOver() const;
    void beginOwn();
    void beginBare();
    void endOwn();
    void endBare();

    HapticLoop& loop_;
    double rate_;
    std::unique_ptr<BareLoop> running_;  ///< empty: the turn is ours
    double blockBegin_ = 0.0;            ///< [s]
    LoopTimes own_;
    LatencyHistogram bare_;
    long bareSkipped_ = 0;
    std::vector<double> ownP99_;   ///< of each block [s]
    std::vector<double> bareP99_;  ///< [s]
};

/// Rate at which one view was drawn.
struct ViewRate {
    std::string view;
    double framesPerSecond = 0.0;
};

/// Measurements of `asperity loop`. Times of fetching and writing are those of a processor.
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

/// Writes one JSON object; times in seconds.
[[nodiscard]] std::string loopReportJson(const LoopReport& report);

/// Writes a few lines for people.
[[nodiscard]] std::string loopReportText(const LoopReport& report);

}  // namespace asperity
