#pragma once

#include "app/window/Stage.h"
#include "app/window/device/DeviceControl.h"

namespace asperity {

/// Brings the tip to the sample up to the setpoint that the window shows, has a feedback hold the
/// force there, and takes the tip away from it.
class EngageControl : public Feature {
    Q_OBJECT

public:
    explicit EngageControl(Stage& stage);

    /// Approaches there (x, y) [m]; engaged() or failed() follows unless something else takes the
    /// tip. There is a run. @param setpoint [N]
    void engage(double setpoint, const Vector2& position);
    /// Returns whether an approach of engage() has the tip.
    [[nodiscard]] bool isEngaging() const { return engaging_ && devices_.approaching() != nullptr; }
    /// Takes the tip out of the sample's reach.
    void withdraw();
    /// Once a frame: follows the approach, the withdrawal and what is held. There is a run.
    void advance();
    /// Every tick, in order: how well the force is held.
    void take(const TickSample& sample);

    /// Returns what a feedback is to hold, from the free force that the last approach measured.
    /// @param setpoint [N]
    [[nodiscard]] HeldForce held(double setpoint) const;
    /// Sets the gain of the feedback, also of the one that holds now.
    void setGain(double gain);
    /// Returns why no feedback can hold the force; empty: it can. There is a run.
    [[nodiscard]] QString holdRefusal() const;
    /// Has a feedback hold the force, mouse and keyboard the rest, as the window says.
    void hold();

Q_SIGNALS:
    void engaged();
    void failed();

private:
    void addEntries();
    /// Returns why the tip cannot approach now; empty: it can.
    [[nodiscard]] QString engageRefusal() const;
    void followApproach();
    void followWithdrawal();
    void followHold();
    void chooseHold(bool force);
    void holdHeight();
    void setSetpoint(double force);
    void showSetpoint();
    void holdSetpoint();
    void forget();

    DeviceControl& devices_;
    bool engaging_ = false;
    bool withdrawing_ = false;
    bool wasHeld_ = false;    ///< in the last run of the same scene
    double asked_ = 0.0;      ///< setpoint of the present approach [N]
    double freeForce_ = 0.0;  ///< measured by the last approach of this run [N]
    double gain_ = kDefaultFeedbackGain;
    FeedbackState state_ = FeedbackState::Holding;  ///< that was told last
    double squares_ = 0.0;    ///< of the errors since the last one was shown [N^2]
    double errorTime_ = 0.0;  ///< over which they add up [s]
    long errorCount_ = 0;
};

}  // namespace asperity
