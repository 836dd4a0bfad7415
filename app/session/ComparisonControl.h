#pragma once

#include "app/loading/ComparedRun.h"
#include "app/session/LongWork.h"
#include "app/session/PlaybackControl.h"

#include <filesystem>

namespace asperity {

/// Overlays a second run on the recording that is looked at, with the difference of their forces.
class ComparisonControl : public QObject {
public:
    ComparisonControl(MainWindow& window, PlaybackControl& playback);

    /// Reads a run in the background; says in the window why it cannot be compared. There is a
    /// recording. @param file its folder, a file in it, or a bundle
    void compareWith(const std::filesystem::path& file);
    /// Nothing comes of the run that is being read.
    void cancel() { work_.cancel(); }

private:
    void ask();
    void show(const ComparedRun& second);

    MainWindow& window_;
    PlaybackControl& playback_;
    std::filesystem::path second_;  ///< asked for last
    LongWork<ComparedRun> work_;
};

}  // namespace asperity
