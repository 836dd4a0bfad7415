#pragma once

#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Validity.h"
#include "ui/panels/RunPanel.h"

#include <QFrame>

#include <array>

class QLabel;
class QPushButton;

namespace asperity {

/// One line that always shows in words and color where the tip is, whether forces act, what went
/// wrong, and what a result does not hold for. Its height never changes.
class StateBanner : public QFrame, public RunPanel {
    Q_OBJECT

public:
    explicit StateBanner(QWidget* parent = nullptr);

    void clear() override;
    /// The flags, so that one that comes and goes can be read.
    void take(const TickSample& sample) noexcept override;
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    /// What the half-space says of the contact, shown from the next tick on: its own force beside
    /// the law's, or that it does not hold; null: nothing.
    void setHalfSpace(const HalfSpaceAnswer* answer);
    /// Whether a force-feedback device is given energy that nobody put in; shown from the next tick
    /// on.
    void setEnergyGiven(bool given) { energyGiven_ = given; }
    /// The run stands still, or goes on.
    void setPaused(bool paused);

Q_SIGNALS:
    /// The user resets the fault.
    void rearmRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showState();
    void showFlags();
    [[nodiscard]] QString stateWords() const;
    [[nodiscard]] QRgb stateColor() const;
    [[nodiscard]] bool isShown(std::size_t index) const;

    Snapshot latest_;
    bool hasRun_ = false;
    bool paused_ = false;
    bool energyGiven_ = false;
    std::array<double, kValidityFlagCount> lastSeen_{};  ///< time of each flag [s]
    QRgb shownColor_ = 0;
    QString caution_;     ///< all flags, whole
    QString halfSpace_;   ///< its force beside the law's
    QString notHolding_;  ///< why it is not shown
    QLabel* state_;
    QLabel* flags_;
    QPushButton* rearm_;
};

}  // namespace asperity
