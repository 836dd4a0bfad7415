#pragma once

#include "ui/plot/CurvePlot.h"
#include "ui/shell/RunPanel.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Steady.h"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

class QGridLayout;
class QTabBar;
class QToolButton;

namespace asperity {

class CyclePanel;

/// The estimated force on the tip with its standard deviation by noise, model and calibration
/// together, the tip's position, gap or indentation and contact radius as numbers; below them
/// curves over the distance or over the last seconds. Tool tips say the two deviations apart, and
/// what they come from.
class ForcePanel : public Card, public RunPanel {
public:
    explicit ForcePanel(QWidget* parent = nullptr);

    /// Forgets the curves of former cycles: they are of another scan.
    void forgetCycles();
    /// Returns what brings back all curves as they are now; the run is the same then.
    [[nodiscard]] std::function<void()> keptCurves();
    void clear() override;
    void rewind() override;
    void begin(const Scene& scene) override;
    /// Keeps a tick for the curves.
    void take(const TickSample& sample) noexcept override;
    /// The numbers of the latest tick, and the curves.
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    [[nodiscard]] ShownNumbers numbers(const Snapshot& snapshot) const override;
    [[nodiscard]] const char* slowName() const override { return "forces"; }
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// Returns the tool tip of a number; empty: of no number. @param label of the number
    [[nodiscard]] QString details(const QLabel* label) const;

    /// The magnitude of the force as it is shown.
    [[nodiscard]] QString magnitude() const;
    [[nodiscard]] const CyclePanel& cycles() const { return *cycles_; }
    [[nodiscard]] CyclePanel& cycles() { return *cycles_; }
    /// Freezes the curves; the numbers go on.
    void setPaused(bool paused);

private:
    void buildNumbers();
    void buildCurves();
    void buildForces(QGridLayout& grid);
    void buildPosition(QGridLayout& grid);
    void buildContact(QGridLayout& grid);
    void clearNumbers();
    void explain(QLabel& label, std::function<QString()> text);
    /// @param way unit vector along which the force is read
    [[nodiscard]] QString forceDetails(const QString& name, const Vector3& way) const;
    [[nodiscard]] QString contactText() const;
    void showForces(const ForceEstimate& estimate);
    void showPosition(const Vector3& tip);
    void showContact(const ContactState& contact);

    const Scene* scene_ = nullptr;     ///< that is shown; none: no budgets
    std::optional<TickOutput> shown_;  ///< the latest tick
    std::vector<std::pair<const QLabel*, std::function<QString()>>> details_;
    std::array<QLabel*, 3> force_{};
    std::array<QLabel*, 3> sigma_{};
    QLabel* magnitude_ = nullptr;
    std::array<QLabel*, 3> tip_{};
    QLabel* distanceName_ = nullptr;  ///< gap, indentation or neck height
    QLabel* distance_ = nullptr;
    QLabel* contactRadius_ = nullptr;
    SteadyScale forceScale_;
    SteadyScale positionScale_;  ///< of x and y
    SteadyScale heightScale_;    ///< of z
    SteadyScale distanceScale_;
    SteadyScale radiusScale_;
    CurvePlot* forcePlot_;
    CurvePlot* heightPlot_;
    CyclePanel* cycles_;
    QTabBar* tabs_;
    QToolButton* pause_;
};

}  // namespace asperity
