#pragma once

#include "core/haptics/VirtualRun.h"

#include <boost/circular_buffer.hpp>

namespace asperity {

/// The last seconds of a live run, tick by tick, with the memory that their first tick starts from:
/// what is needed to see why a fault came, and to replay it to the same bits. It holds them from
/// the first fault on, or when asked to. For the thread that drains the loop; the tick knows
/// nothing of it. After construction it asks for no memory but in release().
class BlackBox {
public:
    /// A replay can begin at every mark; the box begins at one. So it may hold more than was asked
    /// for, by this and the time from one visit to the next [s].
    static constexpr double kMarkSpacing = 0.1;
    static constexpr double kSeconds = 10.0;  ///< that it keeps, at up to 10 kHz

    /// Begins with the first tick of a run.
    /// @param timeStep between ticks [s]
    /// @param seconds how long a stretch it keeps, at least [s]
    explicit BlackBox(double timeStep, double seconds = kSeconds);

    /// Every tick, in order. Where some are missing, what was before them is forgotten, since a
    /// replay cannot go across; a mark of the last missing one stays.
    void take(const TickSample& sample);
    /// The loop's latest tick, taken already or still to come: a mark where one is due.
    void mark(const Snapshot& latest);

    /// Holds what it has; nothing more is taken.
    void freeze() noexcept { frozen_ = true; }
    [[nodiscard]] bool frozen() const noexcept { return frozen_; }
    /// Forgets all and begins again at the next mark. A fault that is latched then does not freeze
    /// it again; the next one does.
    void restart() noexcept;
    /// Moves out what it holds, to be written by another thread, and begins again as restart().
    [[nodiscard]] BlackBox release();

    /// Oldest first. A box that froze by itself ends with the first tick of the fault.
    [[nodiscard]] const boost::circular_buffer<TickSample>& samples() const noexcept {
        return samples_;
    }
    /// State that the first of the samples starts from; only where there are some.
    [[nodiscard]] const TickMemory& memory() const noexcept { return marks_.front().memory; }

private:
    /// Point where a replay can begin: with the first tick after this one.
    struct Mark {
        double time = 0.0;  ///< of the tick [s]
        TickMemory memory;  ///< after it
    };

    void keep(const TickSample& sample);
    void forgetAll() noexcept;
    void forgetBefore(double time) noexcept;
    void forgetUpToSecondMark() noexcept;

    double timeStep_;            ///< [s]
    double seconds_;             ///< [s]
    double lastTime_ = 0.0;      ///< of the newest tick, kept or not [s]
    Fault fault_ = Fault::None;  ///< of that tick
    bool frozen_ = false;
    boost::circular_buffer<TickSample> samples_;
    boost::circular_buffer<Mark> marks_;  ///< the samples begin after the first one
};

}  // namespace asperity
