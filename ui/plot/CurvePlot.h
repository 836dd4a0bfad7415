#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/plot/CopyablePlot.h"
#include "ui/plot/CurveHistory.h"
#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"

#include <QString>
#include <QWidget>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// Labels of a plot's time axis; of plots above one another only the lowest needs them.
enum class TimeLabels { Hidden, Shown };

/// Zero line of a plot; `Shown`: zero is always in sight.
enum class ZeroLine { Shown, None };

/// Content and look of a plot.
struct CurvePlotSetup {
    struct Curve {
        QString name;
        QColor ThemeColors::*color = &ThemeColors::ink;
    };

    QString title;
    QString unit;           ///< SI unit of the values
    double smallest = 0.0;  ///< least extent of the value axis [unit]: smaller noise stays small
    std::vector<Curve> curves;  ///< 1 to 3
    ZeroLine zero = ZeroLine::Shown;
    TimeLabels timeLabels = TimeLabels::Hidden;
};

/// Live curves of one to three quantities of the same unit over the last ten seconds of physics
/// time. The value axis ranges itself and names its unit with the fitting prefix, until a user
/// zooms or pans (PlotNavigation). A hovering pointer reads all curves.
class CurvePlot : public QWidget {
public:
    static constexpr double kSpan = 10.0;  ///< [s]
    using Values = std::array<double, 3>;  ///< in the order of the curves; the rest is ignored

    explicit CurvePlot(const CurvePlotSetup& setup, QWidget* parent = nullptr);
    ~CurvePlot() override;
    CurvePlot(const CurvePlot&) = delete;
    CurvePlot& operator=(const CurvePlot&) = delete;

    /// Keeps the values of one tick at `time` [s]; draws nothing.
    void take(double time, const Values& values) noexcept;
    /// Draws the curves up to the newest time.
    void refresh();
    void clear();
    /// Returns what brings back the curves as they are now.
    [[nodiscard]] std::function<void()> keptCurves();
    /// Freezes what is drawn; values are kept on, so that it goes on with those of now.
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return paused_.has_value(); }

    /// Returns what the cursor reads; empty: the pointer is elsewhere.
    [[nodiscard]] QString reading() const;
    [[nodiscard]] bool isZoomed() const;
    /// The range of the time axis, 0: now [s].
    [[nodiscard]] const AxisRange& shownTimes() const { return shownTimes_; }
    [[nodiscard]] QWidget& canvas();

    /// Time [s] and value of each curve, in the order of time.
    [[nodiscard]] PlotTable table() const;
    [[nodiscard]] const CurveHistory& history(std::size_t curve) const { return histories_[curve]; }
    [[nodiscard]] const AxisRange& valueRange() const { return range_.range(); }  ///< [unit]

private:
    class Canvas;  ///< what Qwt draws
    using Histories = std::vector<CurveHistory>;

    void fitRange();
    [[nodiscard]] const Histories& drawn() const { return paused_ ? *paused_ : histories_; }

    QStringList headers_;  ///< of the curves' values, for table()
    ZeroLine zero_;
    Histories histories_;
    std::optional<Histories> paused_;  ///< as they were then
    AxisRange shownTimes_;
    SteadyRange range_;
    SteadyScale scale_;
    std::unique_ptr<Canvas> canvas_;
};

}  // namespace asperity
