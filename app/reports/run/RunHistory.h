#pragma once

#include "core/Vector.h"
#include "core/haptics/RunEvents.h"
#include "ui/panels/CycleTrace.h"

#include <array>
#include <map>
#include <vector>

namespace asperity {

/// The curve of a touch as it is drawn.
struct TouchCurve {
    ContactCycle cycle;
    CycleTrace trace;
};

/// All that a report shows of a run, taken tick by tick. Events and curves are found as in
/// summary.json and the window.
class RunHistory {
public:
    static constexpr std::size_t kDrawnTouches = 6;  ///< the first of them are drawn

    void take(const TickSample& sample);

    [[nodiscard]] const RunEvents& events() const noexcept { return events_.events(); }
    /// Of the first touches.
    [[nodiscard]] const std::vector<TouchCurve>& curves() const noexcept { return curves_; }
    /// Of a run without a touch: the way of the tip in free air, or beside the sample.
    [[nodiscard]] const CycleTrace& present() const noexcept { return present_; }
    /// Where the tip's apex went [m].
    [[nodiscard]] const std::vector<Vector3>& tipPath() const noexcept { return path_; }
    /// Ticks by the worst flag in them, but for flags of noisy signals, which say little in a tick;
    /// by Severity. Ticks without such a flag are in none.
    [[nodiscard]] const std::array<long, 4>& ticksBySeverity() const noexcept { return worst_; }
    /// Ticks with the force off, by what switched it off.
    [[nodiscard]] const std::map<Fault, long>& faults() const noexcept { return faults_; }
    [[nodiscard]] double duration() const noexcept { return last_ - first_; }  ///< [s]

private:
    void takeCurve(const TickSample& sample);
    void takeFlags(const TickOutput& out);

    RunEventRecorder events_;
    CycleDetector detector_;
    CycleTrace present_;
    std::int64_t number_ = 0;  ///< of the present cycle
    std::vector<TouchCurve> curves_;
    std::vector<Vector3> path_;
    std::array<long, 4> worst_{};
    std::map<Fault, long> faults_;
    double first_ = 0.0;  ///< [s]
    double last_ = 0.0;   ///< [s]
};

}  // namespace asperity
