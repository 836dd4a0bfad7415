#pragma once

#include "core/haptics/VirtualRun.h"

#include <QString>

#include <optional>
#include <vector>

namespace asperity {

struct Scene;

/// A number that the window shows.
struct ShownNumber {
    QString name;
    double value = 0.0;           ///< in `unit`; not finite: nothing is known
    std::optional<double> sigma;  ///< its standard deviation, where one is known
    QString unit;                 ///< SI; empty: a count
    /// Its standard deviation due to model and calibration, where that is known.
    std::optional<double> modelSigma = {};
};

using ShownNumbers = std::vector<ShownNumber>;

/// As tab-separated text: a line of headers, then name, value, standard deviations by noise and by
/// model, and unit of each.
[[nodiscard]] QString tabSeparated(const ShownNumbers& numbers);

/// Panel that shows a run beside the large view.
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

    /// Returns its name in reports where it is drawn in every second frame; null: it is drawn in
    /// every frame, as the large view is.
    [[nodiscard]] virtual const char* slowName() const { return nullptr; }
};

}  // namespace asperity
