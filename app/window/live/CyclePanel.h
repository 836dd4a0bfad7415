#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/uncertainty/LandmarkBudgets.h"
#include "ui/plot/CycleTrace.h"
#include "ui/plot/ForceDistancePlot.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;

namespace asperity {

class CycleTable;
class MeasuredBar;
class NumberBox;

/// One branch of a measured curve; distance [m], force [N]; 0: contact.
struct MeasuredBranchPoints {
    QVector<QPointF> overSeparation;
    QVector<QPointF> overBase;
};

/// A measured force-distance curve that is drawn for comparison.
struct MeasuredCurve {
    QString name;
    QString details;  ///< how it was aligned, for its tool tip
    MeasuredBranchPoints approach;
    MeasuredBranchPoints retract;
    AxisRange contact;  ///< distances that are to be seen [m]
};

/// Force-distance curves of the last cycles, approach and retract over one another, with what is
/// read from them; a click on a row hides or shows its curves. Cycles stay when the material
/// changes, until they are cleared: for comparison. A measured curve can be drawn over them.
class CyclePanel : public QWidget {
    Q_OBJECT

public:
    explicit CyclePanel(QWidget* parent = nullptr);

    /// A run on this material begins. @param scene of it, until end(); null: readings have no
    /// budgets
    void begin(const QString& material, const Scene* scene = nullptr);
    /// The run is over: what the tip did so far stays if it touched.
    void end();
    /// Every tick, cheap.
    void take(const TickSample& sample) noexcept;
    /// Draws what was taken so far.
    void refresh();
    /// Forgets all cycles; one in contact goes on.
    void clear();
    /// Forgets all cycles; the run, which goes on, begins again.
    void restart();
    /// Returns what brings back all cycles as they are now; the run is the same then.
    [[nodiscard]] std::function<void()> keptCycles();
    /// Freezes what is drawn; cycles are kept on.
    void setPaused(bool paused);
    /// Draws it over the cycles, with no offset; none: takes it away.
    void setMeasured(const std::optional<MeasuredCurve>& curve);
    [[nodiscard]] const std::optional<MeasuredCurve>& measured() const { return measured_; }

    /// Returns whether curves are drawn over the base's distance, not over the separation.
    [[nodiscard]] bool showsBase() const;
    [[nodiscard]] const ForceDistancePlot& plot() const { return *plot_; }
    [[nodiscard]] ForceDistancePlot& plot() { return *plot_; }
    [[nodiscard]] const CycleTable& table() const { return *table_; }

Q_SIGNALS:
    /// The user wants to draw one from a file.
    void measuredCurveWanted();

private:
    /// A cycle with its curve.
    struct Kept {
        QString material;
        bool hidden = false;  ///< its curves are not drawn
        ContactCycle cycle;
        CycleTrace trace;
        int run = 0;                             ///< that it is of
        std::optional<LandmarkBudgets> budgets;  ///< at its position, once they were asked for
    };

    /// All cycles, as they are now or were when the plot was paused.
    struct Cycles {
        Kept present;
        std::vector<Kept> older;  ///< the newest first
    };

    void buildHeading();
    void toggle(int row);
    [[nodiscard]] const Cycles& drawnCycles() const { return paused_ ? *paused_ : cycles_; }
    [[nodiscard]] DrawnMeasurement drawnMeasurement() const;
    void endCycle();
    void keep();
    void dropOne();
    /// @param row of the table
    [[nodiscard]] Kept& keptAt(int row);
    /// Computes them if the run is not over: some ten milliseconds.
    void takeBudgets(Kept& kept) const;
    [[nodiscard]] std::vector<const Kept*> shown() const;
    [[nodiscard]] DrawnCycle drawn(const Kept& kept) const;
    [[nodiscard]] AxisRange distancesOf(const std::vector<const Kept*>& cycles) const;

    const Scene* scene_ = nullptr;  ///< of the run; none: there is no run
    int runs_ = 0;
    CycleDetector detector_;
    std::int64_t number_ = 0;  ///< of the present cycle
    Cycles cycles_;
    std::optional<Cycles> paused_;
    std::optional<MeasuredCurve> measured_;
    QComboBox* axis_;
    ForceDistancePlot* plot_;
    CycleTable* table_;
    MeasuredBar* bar_;
};

/// The line below a plot for a measured curve that is drawn in it: name, offset along the distance
/// axis, a button that takes it away. Hidden while there is none.
class MeasuredBar : public QWidget {
    Q_OBJECT

public:
    explicit MeasuredBar(QWidget* parent = nullptr);

    /// Shows a curve with no offset; an empty name: there is none.
    void setCurve(const QString& name, const QString& details);
    [[nodiscard]] double offset() const;  ///< [m]

Q_SIGNALS:
    void offsetChanged();
    void removeChosen();

private:
    void showName();
    void resizeEvent(QResizeEvent* event) override;

    QLabel* name_;
    NumberBox* offset_;
    QString whole_;
};

}  // namespace asperity
