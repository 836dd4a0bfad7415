#pragma once

#include <QString>
#include <QWidget>

#include <initializer_list>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace asperity {

class GainSpinBox;

/// Unit in which a setpoint is typed.
struct SetpointUnit {
    QString name;
    double perNewton = 1e9;  ///< 0: it cannot be typed
    QString whyNot = {};     ///< it cannot be typed, for its tool tip

    bool operator==(const SetpointUnit&) const = default;
};

/// Way of the base straight down to the sample, and up again.
struct Ramp {
    double rate = 0.0;  ///< [m/s]
    double size = 0.0;  ///< from where it begins and ends to the first touch, at least what takes
                        ///< the tip out of the sample's reach [m]
};

/// The row above the view with which a user brings the tip to the sample, holds it there and takes
/// it away. Setters show a state and emit nothing.
class EngageBar : public QWidget {
    Q_OBJECT

public:
    explicit EngageBar(QWidget* parent = nullptr);

    /// Force at which an approach ends, and which is held then [N].
    [[nodiscard]] double setpoint() const { return setpoint_; }
    void setSetpoint(double force);
    /// Sets in which units a setpoint can be typed; the chosen one stays where it can be typed.
    void setUnits(std::vector<SetpointUnit> units);
    [[nodiscard]] Ramp ramp() const;
    /// Sets rate and size that suit the scene, as long as no others are typed; an emptied box
    /// returns to them.
    void setUsualRamp(const Ramp& usual);
    /// Returns whether a feedback is to hold the force; else the height stays.
    [[nodiscard]] bool holdsForce() const;
    void setHoldsForce(bool holds);
    /// @param why it cannot engage, for the button's tool tip; empty: it can
    /// @param whyNotUp the same of withdrawing
    void setRefusals(const QString& why, const QString& whyNotUp);
    /// Shows how well the force is held. @param error in words; empty: it is not held
    void showError(const QString& error);

Q_SIGNALS:
    void engageChosen();
    void withdrawChosen();
    void setpointEntered();              ///< by the Return key
    void setpointChanged(double force);  ///< [N]
    void holdChosen(bool force);         ///< else the height

private:
    /// Adds widgets that stay beside one another; in a narrow window groups are below one another.
    void addGroup(std::initializer_list<QWidget*> widgets);
    void addSetpoint();
    void addRamp();
    void addRampBox(GainSpinBox& box, const char* name, const QString& spoken,
                    const QString& toolTip);
    void addHold();
    [[nodiscard]] const SetpointUnit& unit() const;
    void showSetpoint();
    void showUsualRamp();

    double setpoint_;  ///< [N]
    Ramp usual_;
    std::vector<SetpointUnit> units_;
    GainSpinBox* box_;
    QComboBox* unit_;
    GainSpinBox* rate_;  ///< [nm/s]; muted: the usual one
    GainSpinBox* size_;  ///< [nm]; same
    QPushButton* engage_;
    QPushButton* withdraw_;
    QComboBox* hold_;
    QLabel* error_;
};

}  // namespace asperity
