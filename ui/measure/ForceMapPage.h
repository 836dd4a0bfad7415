#pragma once

#include "core/map/MapQuantity.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace asperity {

class ForceMapForm;
class PixelCurveView;

/// A force map of the scan: what it is asked for, how far it is, which of its quantities colors the
/// surface, and one pixel of it.
class ForceMapPage : public QWidget {
    Q_OBJECT

public:
    explicit ForceMapPage(QWidget* parent = nullptr);

    /// The request cannot be computed, for this reason: Start is disabled. Empty: it can.
    void setRefusal(const QString& reason);
    /// How long that will take.
    void setEstimate(const QString& words);
    /// A map is being computed: nothing else can be asked for.
    void setRunning(bool running);
    /// What there is to say: how far the map is, what it is of.
    void setState(const QString& words);
    /// Which quantities there are to show, and the one that is shown; empty: there is no map.
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
    QLabel* refusal_;  ///< in place of the estimate
    QLabel* state_;
};

}  // namespace asperity
