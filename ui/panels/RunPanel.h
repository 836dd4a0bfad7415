#pragma once

#include "core/haptics/Snapshot.h"
#include "ui/panels/ShownNumbers.h"

namespace asperity {

struct Scene;

/// What shows a run beside the large view.
class RunPanel {
public:
    virtual ~RunPanel() = default;

    /// Forgets what was shown: there is another scene, or none.
    virtual void clear() = 0;
    /// After clear(): the scene that is shown from now on; it outlives that.
    virtual void begin(const Scene& /*scene*/) {}
    /// Forgets the ticks so far, the scene stays: those that come are of another time.
    virtual void rewind() { clear(); }
    /// Keeps one tick; every tick, cheap.
    virtual void take(const TickSample& /*sample*/) noexcept {}
    /// Shows the latest tick; once a frame.
    virtual void show(const Snapshot& snapshot) = 0;

    /// The numbers that it shows of this tick; for the clipboard.
    [[nodiscard]] virtual ShownNumbers numbers(const Snapshot& /*snapshot*/) const { return {}; }

    /// What reports call it where it is drawn in every second frame; null: it is drawn in every
    /// one, as the large view is.
    [[nodiscard]] virtual const char* slowName() const { return nullptr; }
};

}  // namespace asperity
