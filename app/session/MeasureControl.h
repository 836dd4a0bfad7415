#pragma once

#include "app/session/ForceMapControl.h"
#include "app/session/MarkerControl.h"
#include "app/session/MeasuredCurveControl.h"
#include "app/session/ProfileControl.h"
#include "app/session/RoughnessControl.h"
#include "app/session/TouchControl.h"

#include <QTimer>

#include <string>

namespace asperity {

/// The measuring tools: their pages below the view, their marks on the whole scan, their menu.
class MeasureControl : public QObject {
public:
    MeasureControl(MainWindow& window, RunControl& runs, SceneEdits& edits);

    /// Every tick, in order.
    void take(const TickSample& sample) { touches_.take(sample); }
    /// Once a frame. There is a run.
    void show() {
        touches_.show();
        forceMaps_.show();
    }
    /// Ends the tool that has the mouse on the whole scan. @return whether one had it when the
    /// present event of the user began: a key comes in several parts
    bool leaveTool();

    [[nodiscard]] ProfileControl& profile() { return profile_; }
    [[nodiscard]] RoughnessControl& roughness() { return roughness_; }
    [[nodiscard]] ForceMapControl& forceMaps() { return forceMaps_; }
    [[nodiscard]] TouchControl& touches() { return touches_; }
    [[nodiscard]] MeasuredCurveControl& curves() { return curves_; }

private:
    void begin();
    void connectMenu();

    MainWindow& window_;
    RunControl& runs_;
    ProfileControl profile_;
    RoughnessControl roughness_;
    ForceMapControl forceMaps_;
    MarkerControl markers_;
    TouchControl touches_;
    MeasuredCurveControl curves_;
    QTimer leaving_;    ///< runs until the event that ended a tool is over
    std::string scan_;  ///< that lines and rectangles were drawn on
};

}  // namespace asperity
