#pragma once

#include "ui/panels/MapTool.h"

#include <QPoint>
#include <QRectF>
#include <QSize>

#include <optional>

namespace asperity {

/// A map of a part of the scan, as its marks need it.
struct MappedPart {
    QRectF region;  ///< world x, y [m]; its top() is the smallest y
    QSize pixels;   ///< columns and rows, row 0 at the largest y
    QString label;  ///< what it shows
};

/// Outlines a map on the whole scan, and chooses a pixel of it: by a click, or as a drag goes on.
class PixelTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    /// None: there is no map. Another place or another grid forgets the pixel.
    void setPart(const std::optional<MappedPart>& part);
    /// The pixel that is marked: column and row; none: none.
    void setPixel(const std::optional<QPoint>& pixel);
    [[nodiscard]] const std::optional<QPoint>& pixel() const { return pixel_; }

    void paint(QPainter& painter, const OverviewMap& map) const override;
    void press(const MapPointer& pointer, const OverviewMap& map) override;
    void drag(const MapPointer& pointer, const OverviewMap& map) override;
    [[nodiscard]] Qt::CursorShape cursor(const MapPointer& pointer,
                                         const OverviewMap& map) const override;
    [[nodiscard]] QString hint() const override;

Q_SIGNALS:
    void pixelChosen(QPoint pixel);

private:
    /// The pixel that a place [m] lies in; none: it lies beside the map.
    [[nodiscard]] std::optional<QPoint> pixelAt(const QPointF& place) const;
    void paintPixel(QPainter& painter, const OverviewMap& map) const;

    std::optional<MappedPart> part_;
    std::optional<QPoint> pixel_;
};

}  // namespace asperity
