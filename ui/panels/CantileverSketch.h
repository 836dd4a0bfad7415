#pragma once

#include "core/Vector.h"
#include "core/probe/Cantilever.h"
#include "core/probe/CantileverShape.h"
#include "ui/Steady.h"

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

    /// By how much the drawing exaggerates.
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
    /// Of the force at the tip, for a drawing turned by the angle with this sine and cosine [px].
    [[nodiscard]] QPointF forceArrow(double sine, double cosine) const;
    void drawEnd(QPainter& painter, const View& view) const;

    std::optional<Cantilever> cantilever_;
    Vector3 force_ = Vector3::Zero();  ///< [N]
    CantileverShape largest_;
    SteadyFactor bendingFactor_;
    SteadyFactor torsionFactor_;
};

}  // namespace asperity
