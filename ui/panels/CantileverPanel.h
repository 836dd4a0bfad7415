#pragma once

#include "core/probe/Cantilever.h"
#include "core/probe/CantileverShape.h"
#include "ui/Steady.h"
#include "ui/panels/Card.h"
#include "ui/panels/CurvePlot.h"
#include "ui/panels/RunPanel.h"

#include <optional>

namespace asperity {

class CantileverSketch;

/// What the cantilever does: a drawing of the bent and twisted beam, the measured bending and
/// torsion as numbers and curves, and the tip's deflection by the estimated force.
class CantileverPanel : public Card, public RunPanel {
public:
    explicit CantileverPanel(QWidget* parent = nullptr);

    /// The believed lever of a new scene; forgets what was shown of the old one.
    void setCantilever(const Cantilever& cantilever);
    void clear() override;
    void begin(const Scene& scene) override;
    /// For the curves.
    void take(const TickSample& sample) noexcept override;
    /// The numbers of the latest tick, the drawing and the curves.
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    [[nodiscard]] ShownNumbers numbers(const Snapshot& snapshot) const override;
    [[nodiscard]] const char* slowName() const override { return "cantilever"; }

    [[nodiscard]] const CurvePlot& plot() const { return *plot_; }
    [[nodiscard]] const CantileverSketch& sketch() const { return *sketch_; }

private:
    void buildNumbers();
    [[nodiscard]] CantileverShape largestShape() const;
    /// How far the estimated force moves the tip, in the lever's frame [m].
    [[nodiscard]] Vector3 tipDeflection(const Snapshot& snapshot) const;

    std::optional<Cantilever> cantilever_;
    CurveHistory deflections_;  ///< of the free end [m]
    CurveHistory torsions_;     ///< of the free end, by the estimated force [rad]
    SteadyScale angleScale_;
    SteadyScale lengthScale_;
    QLabel* bending_ = nullptr;
    QLabel* torsion_ = nullptr;
    QLabel* deflection_ = nullptr;
    QLabel* lateral_ = nullptr;
    CantileverSketch* sketch_;
    CurvePlot* plot_;
};

}  // namespace asperity
