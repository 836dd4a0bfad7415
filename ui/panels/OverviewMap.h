#pragma once

#include "ui/panels/ReliefImage.h"

#include <QPixmap>
#include <QPolygonF>
#include <QWidget>

#include <optional>

namespace asperity {

/// The scan from above, aspect ratio kept, with the tip's place, the zoomed view's frame, the path
/// of a scripted device and a scale bar. Places are world x, y [m], y up.
class OverviewMap : public QWidget {
    Q_OBJECT

public:
    explicit OverviewMap(QWidget* parent = nullptr);

    /// Draws the relief once; forgets tip, frame and path.
    void setSurface(const BSplineSurface& surface);
    void showTip(const QPointF& place);
    void hideTip();
    void showFrame(const QRectF& frame);
    void showPath(const QPolygonF& path);

    /// Where the scan is drawn, in this widget's pixels; empty before there is one.
    [[nodiscard]] QRectF mapRect() const;
    [[nodiscard]] QPointF toPixel(const QPointF& place) const;
    [[nodiscard]] QPointF toPlace(const QPointF& pixel) const;
    /// What stands under a pixel, in words; empty beside the scan.
    [[nodiscard]] QString toolTipAt(const QPointF& pixel) const;
    [[nodiscard]] const ColorScale& colors() const { return relief_.colors; }
    /// Whether the scan holds no data somewhere.
    [[nodiscard]] bool hasFilled() const { return relief_.hasFilled; }

Q_SIGNALS:
    /// A user wants to go there: double click [m].
    void placeChosen(double x, double y);

protected:
    bool event(QEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] double heightAt(const QPointF& place) const;  ///< [m]
    void drawScaleBar(QPainter& painter, const QRectF& map) const;
    void drawFrame(QPainter& painter) const;
    void drawTip(QPainter& painter, const QRectF& map) const;

    ReliefImage relief_;
    QSizeF size_;     ///< of the scan [m]
    QPixmap scaled_;  ///< the relief at the size drawn
    std::optional<QPointF> tip_;
    QRectF frame_;
    QPolygonF path_;
};

}  // namespace asperity
