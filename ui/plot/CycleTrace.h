#pragma once

#include "core/haptics/cycle/CycleDetector.h"

#include <array>
#include <cstddef>

namespace asperity {

/// A point to be drawn: the mean over a short way of the base.
struct TracePoint {
    double separation = 0.0;    ///< [m]
    double baseDistance = 0.0;  ///< [m]
    double force = 0.0;         ///< [N]
    CurveBranch branch = CurveBranch::Approach;
    bool contact = false;
};

/// The curve of one cycle in at most kRoom points, however long it takes and however far it goes.
/// Points are as near to one another as their room allows, and nearer in contact than before it; a
/// jump of the force always parts two of them. Where there is no room left after a cycle, what the
/// tip does then is left out. O(1) a tick on average, allocation-free.
class CycleTrace {
public:
    static constexpr std::size_t kRoom = 640;

    /// Takes the latest tick of the detector.
    void take(const CycleDetector& detector) noexcept;
    void clear() noexcept { *this = {}; }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    /// In the order of time; i < size().
    [[nodiscard]] const TracePoint& operator[](std::size_t i) const noexcept { return points_[i]; }

private:
    void enter(CyclePhase phase) noexcept;
    void begin(const TracePoint& point) noexcept;
    void thin() noexcept;

    std::array<TracePoint, kRoom> points_{};  ///< the last one is the mean of ticks_ so far
    std::size_t size_ = 0;
    double spacing_ = 0.0;    ///< of two points [m]
    double ticks_ = 0.0;      ///< in the last point
    double firstBase_ = 0.0;  ///< base distance of the first of them [m]
    CyclePhase phase_ = CyclePhase::Apart;
};

}  // namespace asperity
