#pragma once

#include "core/Vector.h"
#include "core/experiment/Study.h"
#include "ui/experiment/TargetTool.h"

#include <optional>

namespace asperity {

class MainWindow;

/// What the views show of a study: the target, as wide a part of the sample for all participants,
/// and nothing that the study takes away.
class StudyViews {
public:
    explicit StudyViews(MainWindow& window);

    /// A study begins: direction and options are the study's.
    void begin(const Study& study);
    /// The tip is at the start of a trial. @param target [m]
    void showTrial(const Vector3& target);
    void forgetTarget() { showTarget(std::nullopt); }
    /// Turns the large view by steps.
    void turn(int right, int up);

private:
    void showTarget(const std::optional<Vector3>& target);

    MainWindow& window_;
    TargetTool mark_;
    double halfWidth_ = 0.0;  ///< of the large view when a trial begins [m]
};

}  // namespace asperity
