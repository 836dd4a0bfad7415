#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"
#include "core/curves/AlignedForceCurve.h"
#include "ui/panels/CyclePanel.h"

#include <filesystem>

namespace asperity {

/// Draws a measured force-distance curve over those of the run.
class MeasuredCurveControl : public QObject {
    Q_OBJECT

public:
    MeasuredCurveControl(MainWindow& window, RunControl& runs, CyclePanel& panel);

    /// Asks for a file.
    void ask();
    /// Reads and aligns a curve in the background; says in the window when that fails. There is a
    /// run.
    void load(const std::filesystem::path& file);

Q_SIGNALS:
    void loaded();

private:
    MainWindow& window_;
    RunControl& runs_;
    CyclePanel& panel_;
    BackgroundWork<MeasuredCurve> work_;
};

/// A curve as the plot draws it: few enough points for each frame, with all its jumps.
[[nodiscard]] MeasuredCurve drawnCurve(const AlignedForceCurve& curve, const QString& name);

}  // namespace asperity
