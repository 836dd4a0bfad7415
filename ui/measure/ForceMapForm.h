#pragma once

#include "core/map/MapPlan.h"

#include <QRectF>
#include <QSizeF>
#include <QWidget>

#include <array>

class QComboBox;
class QSpinBox;
class QToolButton;

namespace asperity {

class NumberBox;

/// What a force map is asked for: mode, region, pixels, setpoint, instrument. Regions are world
/// x, y [m]; the top() of a rectangle is its smallest y.
class ForceMapForm : public QWidget {
    Q_OBJECT

public:
    explicit ForceMapForm(QWidget* parent = nullptr);

    /// Another scan: the region is all of it. @param size [m]
    void setScan(const QSizeF& size);
    /// That of the scene [N], as long as no other is typed.
    void setSetpoint(double force);
    /// The part that is in view; it may reach beyond the scan.
    void setView(const QRectF& frame);
    /// A rectangle is drawn on the scan: it is the region.
    void setRectangle(const QRectF& rectangle);
    /// Shows whether a drag on the whole scan draws the rectangle.
    void setDrawing(bool drawing);

    /// What was typed half counts now.
    void takeTyped();
    [[nodiscard]] MapRequest request() const;
    /// The rectangle that is asked for, for its tool: empty where it is the whole scan, or the part
    /// in view.
    [[nodiscard]] QRectF rectangle() const;

Q_SIGNALS:
    /// request() is another one.
    void changed();
    void drawingChosen(bool drawing);

private:
    enum class Area { Whole, View, Rectangle };

    void addParts();
    void connectParts();
    [[nodiscard]] Area area() const;
    void choose(Area area);
    /// Shows the region of the choice in the fields, and the pixels that suit it.
    void showRegion();
    void takeFields();
    void suggestPixels();
    [[nodiscard]] MapRegion region() const;

    QSizeF scan_;          ///< [m]
    QRectF view_;          ///< [m]
    MapRegion rectangle_;  ///< drawn or typed
    bool hasOwnSetpoint_ = false;
    bool hasOwnPixels_ = false;
    QComboBox* mode_;
    NumberBox* setpoint_;  ///< [nN]
    QComboBox* area_;
    QToolButton* draw_;
    std::array<NumberBox*, 4> sides_;  ///< left, right, bottom, top [nm]
    QSpinBox* columns_;
    QSpinBox* rows_;
    QComboBox* instrument_;
};

}  // namespace asperity
