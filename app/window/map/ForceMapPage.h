#pragma once

#include "core/map/MapPlan.h"
#include "core/map/MapQuantity.h"

#include <QRectF>
#include <QSizeF>
#include <QWidget>

#include <array>
#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;
class QSpinBox;

namespace asperity {

class NumberBox;
class PixelCurveView;

/// Request of a force map: mode, region, pixels, setpoint, instrument. Regions are world x, y [m];
/// the top() of a rectangle is its smallest y.
class ForceMapForm : public QWidget {
    Q_OBJECT

public:
    explicit ForceMapForm(QWidget* parent = nullptr);

    /// Another scan: the region is all of it. @param size [m]
    void setScan(const QSizeF& size);
    /// Sets the setpoint of the scene [N], as long as no other is typed.
    void setSetpoint(double force);
    /// The part that is in view; it may reach beyond the scan.
    void setView(const QRectF& frame);
    /// A rectangle is drawn on the scan: it is the region.
    void setRectangle(const QRectF& rectangle);
    /// Shows whether a drag on the whole scan draws the rectangle.
    void setDrawing(bool drawing);

    /// Accepts numbers that are still being typed.
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

/// A force map of the scan: what it is asked for, how far it is, which of its quantities colors the
/// surface, and one pixel of it.
class ForceMapPage : public QWidget {
    Q_OBJECT

public:
    explicit ForceMapPage(QWidget* parent = nullptr);

    /// The request cannot be computed, for this reason: Start is disabled. Empty: it can.
    void setRefusal(const QString& reason);
    void setEstimate(const QString& words);
    /// A map is being computed: nothing else can be asked for.
    void setRunning(bool running);
    /// Shows the state: progress of the map, and the scene that it is of.
    void setState(const QString& words);
    /// Sets the quantities to choose from, and the one that is shown; empty: there is no map.
    void setQuantities(const std::vector<MapQuantity>& quantities, MapQuantity shown);
    /// Shows whether a click on the whole scan chooses a pixel.
    void setPicking(bool picking);

    [[nodiscard]] ForceMapForm& form() { return *form_; }
    [[nodiscard]] PixelCurveView& pixel() { return *pixel_; }
    [[nodiscard]] QString state() const;

Q_SIGNALS:
    void startChosen();
    void cancelChosen();
    void saveChosen();
    void quantityChosen(MapQuantity quantity);
    void pickingChosen(bool picking);
    /// The user looks at it now.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void showButtons();
    void connectParts();
    [[nodiscard]] QWidget* newBar();

    bool running_ = false;
    std::vector<MapQuantity> quantities_;
    ForceMapForm* form_;
    PixelCurveView* pixel_;
    QToolButton* start_;
    QToolButton* cancel_;
    QToolButton* pick_;
    QToolButton* save_;
    QComboBox* shown_;
    QLabel* estimate_;
    QLabel* refusal_;  ///< instead of the estimate
    QLabel* state_;
};

}  // namespace asperity
