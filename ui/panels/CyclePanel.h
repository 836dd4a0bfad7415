#pragma once

#include "core/haptics/VirtualRun.h"
#include "ui/panels/CycleTrace.h"
#include "ui/panels/ForceDistancePlot.h"

#include <QString>
#include <QWidget>

#include <vector>

class QComboBox;

namespace asperity {

class CycleTable;

/// Force-distance curves of the last cycles, approach and retract over one another, with what is
/// read from them. Cycles stay when the material changes, until they are cleared: for comparison.
class CyclePanel : public QWidget {
    Q_OBJECT

public:
    explicit CyclePanel(QWidget* parent = nullptr);

    /// A run on this material begins.
    void begin(const QString& material);
    /// The run is over: what the tip did so far stays if it touched.
    void end();
    /// Every tick, cheap.
    void take(const TickSample& sample) noexcept;
    /// Draws what was taken so far.
    void refresh();
    /// Forgets all cycles; one in contact goes on.
    void clear();

    [[nodiscard]] const ForceDistancePlot& plot() const { return *plot_; }
    [[nodiscard]] const CycleTable& table() const { return *table_; }

private:
    /// A cycle with its curve.
    struct Kept {
        QString material;
        ContactCycle cycle;
        CycleTrace trace;
    };

    void buildHeading();
    void keep();
    void dropOne();
    [[nodiscard]] std::vector<const Kept*> shown() const;
    [[nodiscard]] bool showsBase() const;
    [[nodiscard]] DrawnCycle drawn(const Kept& kept) const;
    [[nodiscard]] AxisRange distancesOf(const std::vector<const Kept*>& cycles) const;

    CycleDetector detector_;
    std::int64_t number_ = 0;  ///< of the present cycle
    Kept present_;
    std::vector<Kept> older_;  ///< the newest first
    QComboBox* axis_;
    ForceDistancePlot* plot_;
    CycleTable* table_;
};

}  // namespace asperity
