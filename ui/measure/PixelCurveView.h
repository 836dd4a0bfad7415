#pragma once

#include "core/map/PixelCurve.h"

#include <QString>
#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QStackedWidget;

namespace asperity {

class ForceDistancePlot;
class ReadingGrid;

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
    /// What a reading shows, by the key of the quantity.
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
