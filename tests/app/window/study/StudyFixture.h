#pragma once

#include "core/experiment/TrialPlan.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/app/window/study/ShortStudy.h"

#include <string>
#include <vector>

namespace asperity::test {

/// The window with a short study, done by mouse and keys.
class WindowWithStudy : public Window {
protected:
    void start(const Study& wanted);
    [[nodiscard]] std::filesystem::path out() { return folder.path() / "out"; }
    std::string action();
    /// As a person does, who sees the tip first, and not right after another press.
    void pressButton();
    bool isInTrial() { return action().starts_with("Done"); }
    bool isReady() { return action().starts_with("Begin"); }

    /// Of the tick that the last frame shows [s].
    double shownTime() { return stage.runs().shown().sample.time; }
    Vector3 tip();
    Vector3 target();
    bool isAtStart();
    /// Begins a trial, brings the tip onto the surface at the target, and ends it.
    void doTrial();
    std::vector<TrialRecord> trials();

    Study study;

private:
    /// Of the tip from the target, along the sample [m].
    double missing() { return (tip() - target()).head<2>().norm(); }
    /// Drags the tip above the target, as seen on the screen.
    void dragAcross();
    /// Turns the wheel until the tip touches.
    void goDown();
};

}  // namespace asperity::test
