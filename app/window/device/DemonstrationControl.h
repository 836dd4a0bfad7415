#pragma once

#include "app/window/Stage.h"
#include "app/window/device/DeviceControl.h"
#include "app/window/device/EngageControl.h"

class QAction;

namespace asperity {

/// Moves the tip to the sample and away from it by itself, again and again, so that a newcomer sees
/// what the program is about. Mouse or keyboard end it, and so does a device that renders forces.
class DemonstrationControl : public Feature {
    Q_OBJECT

public:
    explicit DemonstrationControl(Stage& stage);

    /// Begins with the next run, unless the user does not want it.
    void beginWithNextRun();
    [[nodiscard]] bool isPlaying() const { return isPlaying_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Step : std::uint8_t { Away, Approaching, InContact, Withdrawing };

    void begin();
    void end();
    void go(Step step);
    void advance(double elapsed);
    [[nodiscard]] bool mayGoOn() const;

    DeviceControl& devices_;
    EngageControl& engaging_;
    QAction* atStart_ = nullptr;
    bool isWanted_ = false;  ///< with the next run
    bool isPlaying_ = false;
    Step step_ = Step::Away;
    double inStep_ = 0.0;  ///< [s]
};

}  // namespace asperity
