#pragma once

#include "ui/InputHelp.h"
#include "ui/panels/ReliefImage.h"

#include <QPixmap>
#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace asperity {

class MapTool;
struct MapPointer;

/// The scan from above, aspect ratio kept, with the tip's place, the zoomed view's frame, the path
/// of a scripted device and a scale bar. Places are world x, y [m], y up.
class OverviewMap : public QWidget {
    Q_OBJECT

public:
    explicit OverviewMap(QWidget* parent = nullptr);

    /// What the mouse does to it.
    [[nodiscard]] static InputHelps help();

    /// Draws the relief once; forgets tip, frame and path.
    void setSurface(const BSplineSurface& surface);
    /// How the surface is colored. @param field what the look's quantity is on the surface
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    void showTip(const QPointF& place);
    void hideTip();
    void showFrame(const QRectF& frame);
    void showPath(const QPolygonF& path);
    /// Two lines that cross at a place, and what is read there; none: neither.
    void showCrossHair(const std::optional<QPointF>& place, const QString& reading);

    [[nodiscard]] const std::optional<QPointF>& crossHair() const { return crossHair_; }

    /// Where the scan is drawn, in this widget's pixels; empty before there is one.
    [[nodiscard]] QRectF mapRect() const;
    [[nodiscard]] QPointF toPixel(const QPointF& place) const;
    [[nodiscard]] QPointF toPlace(const QPointF& pixel) const;
    /// What stands under a pixel, in words; empty beside the scan.
    [[nodiscard]] QString toolTipAt(const QPointF& pixel) const;
    [[nodiscard]] const ColorScale& colors() const { return relief_.colors(); }
    /// Whether the scan holds no data somewhere.
    [[nodiscard]] bool hasFilled() const { return relief_.hasFilled(); }
    /// Whether the quantity shown misses values.
    [[nodiscard]] bool hasGaps() const { return relief_.hasGaps(); }
    [[nodiscard]] const QSizeF& scanSize() const { return size_; }  ///< [m]
    /// The place on the scan that is nearest to this one [m].
    [[nodiscard]] QPointF onScan(const QPointF& place) const;

    /// Shows the marks of a tool, as long as it lives, above those of earlier ones.
    void addTool(MapTool& tool);
    /// From now on the left button is this tool's; null: nobody's, and a double click travels.
    void activate(MapTool* tool);
    [[nodiscard]] MapTool* activeTool() const { return active_; }

Q_SIGNALS:
    /// A user wants to go there: double click [m].
    void placeChosen(double x, double y);
    /// Another tool is active; null: none is.
    void toolActivated(MapTool* tool);
    /// The pointer is over this place [m].
    void placeHovered(double x, double y);
    /// The pointer is over the scan no more.
    void placeLeft();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] MapPointer pointerOf(const QMouseEvent& event) const;
    /// Whether the active tool gets what this button does.
    [[nodiscard]] bool belongsToTool(const QMouseEvent& event) const;
    [[nodiscard]] double heightAt(const QPointF& place) const;  ///< [m]
    void drawScaleBar(QPainter& painter, const QRectF& map) const;
    void drawFrame(QPainter& painter) const;
    void drawTip(QPainter& painter, const QRectF& map) const;
    void drawCrossHair(QPainter& painter, const QRectF& map) const;

    ReliefImage relief_;
    QSizeF size_;     ///< of the scan [m]
    QPixmap scaled_;  ///< the relief at the size drawn
    std::optional<QPointF> tip_;
    QRectF frame_;
    QPolygonF path_;
    std::vector<MapTool*> tools_;  ///< in the order in which they are drawn
    MapTool* active_ = nullptr;
    bool pressed_ = false;  ///< the active tool has the left button
    std::optional<QPointF> crossHair_;
    QString reading_;  ///< of the cross-hair
};

}  // namespace asperity
