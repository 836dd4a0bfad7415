#pragma once

#include "ui/view/MapTool.h"
#include "ui/view/ReliefImage.h"
#include "ui/widgets/InputHelp.h"

#include <QPixmap>
#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace asperity {

class MapTool;
struct MapPointer;

/// Scan from above, aspect ratio kept, with the tip's position, the zoomed view's frame, the path
/// of a scripted device and a scale bar. Positions are world x, y [m], y up.
class OverviewMap : public QWidget {
    Q_OBJECT

public:
    explicit OverviewMap(QWidget* parent = nullptr);

    /// Returns what the mouse does to the map, for help.
    [[nodiscard]] static InputHelps help();

    /// Draws the relief once; forgets tip, frame and path.
    void setSurface(const BSplineSurface& surface);
    /// Sets how the surface is colored. @param field the look's quantity on the surface
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    void showTip(const QPointF& position);
    void hideTip();
    void showFrame(const QRectF& frame);
    void showPath(const QPolygonF& path);
    /// Two lines that cross at a position, and what is read there; none: neither.
    void showCrossHair(const std::optional<QPointF>& position, const QString& reading);

    [[nodiscard]] const std::optional<QPointF>& crossHair() const { return crossHair_; }

    /// Returns the rectangle of the scan in this widget's pixels; empty before there is one.
    [[nodiscard]] QRectF mapRect() const;
    [[nodiscard]] QPointF toPixel(const QPointF& position) const;
    [[nodiscard]] QPointF toPosition(const QPointF& pixel) const;
    /// Returns what is under a pixel, in words; empty beside the scan.
    [[nodiscard]] QString toolTipAt(const QPointF& pixel) const;
    [[nodiscard]] const ColorScale& colors() const { return relief_.colors(); }
    /// Returns whether parts of the scan hold no data.
    [[nodiscard]] bool hasFilled() const { return relief_.hasFilled(); }
    /// Returns whether the quantity shown misses values.
    [[nodiscard]] bool hasGaps() const { return relief_.hasGaps(); }
    [[nodiscard]] const QSizeF& scanSize() const { return size_; }  ///< [m]
    /// The position on the scan that is nearest to this one [m].
    [[nodiscard]] QPointF onScan(const QPointF& point) const;

    /// Shows the marks of a tool, as long as it lives, above those of earlier ones.
    void addTool(MapTool& tool);
    /// From now on the left button is this tool's; null: nobody's, and a double click travels.
    void activate(MapTool* tool);
    [[nodiscard]] MapTool* activeTool() const { return active_; }

Q_SIGNALS:
    /// A user wants to go there: double click [m].
    void positionChosen(double x, double y);
    /// Another tool is active; null: none is.
    void toolActivated(MapTool* tool);
    /// The pointer is over this position [m].
    void positionHovered(double x, double y);
    /// The pointer is over the scan no more.
    void pointerLeft();

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
    /// Returns whether the active tool receives what this button does.
    [[nodiscard]] bool belongsToTool(const QMouseEvent& event) const;
    [[nodiscard]] double heightAt(const QPointF& position) const;  ///< [m]
    /// @param painter has the letters of its number
    [[nodiscard]] ScaleBar scaleBar(const QPainter& painter, const QRectF& map) const;
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

/// Has the switch of a page activate its tool on the whole scan, and show whether it is active.
template <typename Page>
void bindTool(OverviewMap& map, MapTool& tool, Page& page, void (Page::*chosen)(bool),
              void (Page::*show)(bool)) {
    map.addTool(tool);
    QObject::connect(&page, chosen, &tool, [&map, &tool](bool active) {
        if (active) {
            map.activate(&tool);
        } else if (map.activeTool() == &tool) {
            map.activate(nullptr);
        }
    });
    QObject::connect(
        &map, &OverviewMap::toolActivated, &page,
        [&page, &tool, show](const MapTool* active) { (page.*show)(active == &tool); });
}

}  // namespace asperity
