#pragma once

#include <QWidget>

class QPushButton;

namespace asperity {

class GainSpinBox;

/// The row above the view with which a user brings the tip to the sample and away from it. Setters
/// show a state and emit nothing.
class EngageBar : public QWidget {
    Q_OBJECT

public:
    explicit EngageBar(QWidget* parent = nullptr);

    /// The force at which an approach ends [N].
    [[nodiscard]] double setpoint() const;
    void setSetpoint(double force);
    /// @param why it cannot engage, for the button's tool tip; empty: it can
    /// @param whyNotUp the same of withdrawing
    void setRefusals(const QString& why, const QString& whyNotUp);

Q_SIGNALS:
    void engageChosen();
    void withdrawChosen();
    void setpointEntered();              ///< by the Return key
    void setpointChanged(double force);  ///< [N]

private:
    GainSpinBox* setpoint_;
    QPushButton* engage_;
    QPushButton* withdraw_;
};

}  // namespace asperity
