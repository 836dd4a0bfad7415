#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/live/CyclePanel.h"
#include "core/curves/AlignedForceCurve.h"

#include <filesystem>

namespace asperity {

/// Draws a measured force-distance curve over those of the run.
class MeasuredCurveControl : public Feature {
    Q_OBJECT

public:
    explicit MeasuredCurveControl(Stage& stage);

    /// Asks for a file.
    void ask();
    /// Reads and aligns a curve in the background; says in the window when that fails. There is a
    /// run.
    void load(const std::filesystem::path& file);

Q_SIGNALS:
    void loaded();

private:
    CyclePanel& panel_;
    BackgroundWork<MeasuredCurve> work_;
};

/// A curve as the plot draws it: few enough points for each frame, with all its jumps.
[[nodiscard]] MeasuredCurve drawnCurve(const AlignedForceCurve& curve, const QString& name);

}  // namespace asperity
