#pragma once

#include "core/Vector.h"
#include "core/probe/CantileverModes.h"
#include "ui/plot/CurvePlot.h"
#include "ui/shell/RunPanel.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/Steady.h"

#include <QWidget>

#include <optional>

class QPainter;

namespace asperity {

/// The cantilever from the side and from its free end, bent and twisted by a force. Lengths are
/// true to one another; the bending and the torsion are exaggerated, and the drawing says by how
/// much.
class CantileverSketch : public QWidget {
public:
    explicit CantileverSketch(QWidget* parent = nullptr);

    void setCantilever(const Cantilever& cantilever);
    /// @param force on the tip, lab frame [N]
    /// @param largest deflection and torsion of the last seconds: what must fit in
    void showForce(const Vector3& force, const CantileverShape& largest);

    [[nodiscard]] double bendingFactor() const { return bendingFactor_.factor(); }
    [[nodiscard]] double torsionFactor() const { return torsionFactor_.factor(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Half of the drawing: where, and how many pixels a meter takes.
    struct View {
        QRectF box;
        double scale = 0.0;  ///< [px/m]
    };

    [[nodiscard]] View sideView() const;
    [[nodiscard]] View endView() const;
    void fitFactors();
    void drawSide(QPainter& painter, const View& view) const;
    /// Returns the arrow of the tip force, for a drawing turned by this sine and cosine [px].
    [[nodiscard]] QPointF forceArrow(double sine, double cosine) const;
    void drawEnd(QPainter& painter, const View& view) const;

    std::optional<Cantilever> cantilever_;
    Vector3 force_ = Vector3::Zero();  ///< [N]
    CantileverShape largest_;
    SteadyFactor bendingFactor_;
    SteadyFactor torsionFactor_;
};

/// State of the cantilever: a drawing of the bent and twisted beam, the measured bending and
/// torsion as numbers and curves, and the tip's deflection by the estimated force.
class CantileverPanel : public Card, public RunPanel {
public:
    explicit CantileverPanel(QWidget* parent = nullptr);

    /// The believed lever of a new scene; forgets what was shown of the old one.
    void setCantilever(const Cantilever& cantilever);
    void clear() override;
    void begin(const Scene& scene) override;
    /// Keeps a tick for the curves.
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
    /// Returns the displacement of the tip by the estimated force, in the lever's frame [m].
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
