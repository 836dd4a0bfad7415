#pragma once

#include "core/map/PixelCycle.h"
#include "ui/view/MapTool.h"

#include <QPoint>
#include <QRectF>
#include <QSize>
#include <QString>
#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QStackedWidget;

namespace asperity {

class ForceDistancePlot;
class ReadingGrid;

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

    /// None: there is no map. Another position or another grid forgets the pixel.
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
    /// The pixel that a position [m] lies in; none: it lies beside the map.
    [[nodiscard]] std::optional<QPoint> pixelAt(const QPointF& position) const;
    void paintPixel(QPainter& painter, const OverviewMap& map) const;

    std::optional<MappedPart> part_;
    std::optional<QPoint> pixel_;
};

/// A pixel of a force map: its force curve, approach and retract over one another, and what the map
/// has there.
class PixelCurveView : public QWidget {
    Q_OBJECT

public:
    explicit PixelCurveView(QWidget* parent = nullptr);

    /// @param title which pixel it is, and what is to be said of it
    /// @param mode of the map that the values are of; the curve is that of mode approach
    void setPixel(const QString& title, const PixelCurve& curve, MapMode mode,
                  const MapValues& values);
    /// No pixel is chosen. @param title what to do
    void clear(const QString& title);

    [[nodiscard]] const ForceDistancePlot& plot() const { return *plot_; }
    [[nodiscard]] QString title() const;
    /// Returns the text of a reading, by the key of the quantity.
    [[nodiscard]] QString reading(MapQuantity quantity) const;

private:
    [[nodiscard]] ReadingGrid* newReadings(MapMode mode);
    [[nodiscard]] ReadingGrid& readings() const;
    void showValues(const MapValues& values);
    void draw();

    std::optional<PixelCurve> curve_;
    MapMode mode_ = MapMode::Approach;
    QLabel* title_;
    QComboBox* axis_;
    ForceDistancePlot* plot_;
    QStackedWidget* stack_;  ///< of the readings, by mode
};

}  // namespace asperity
