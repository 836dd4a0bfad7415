#pragma once

#include "app/loading/ComparedRun.h"
#include "app/recording/RunComparison.h"
#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/recording/PlaybackPage.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A recorded run that is looked at.
struct LookedAtRun {
    std::filesystem::path input;  ///< its folder, or a bundle; empty: the last seconds of the run
    std::string note;             ///< on a run that is not complete; empty: it is
    RunConditions conditions;
    RunSurvey survey;
    std::shared_ptr<const LoadedScene> loaded;  ///< lives as long as the playback needs it
    std::optional<RunPlayback> playback;        ///< only one thread asks it for ticks
    std::size_t first = 0;                      ///< the tick that is shown first
};

/// Asks for a file of a recorded run's folder, or a bundle. @return empty: the user canceled
[[nodiscard]] QString askForRun(QWidget& window, const QString& title);

/// Returns the curves of a run: thinned where it has more ticks than can be seen.
[[nodiscard]] PlaybackPage::Curves curvesOf(const ForceTrace& trace, const QString& name,
                                            double shift = 0.0);

/// Shows recorded runs in the window, any moment of them, while the live loop rests: from a disk,
/// or the last seconds of the live run in slow motion.
class PlaybackControl : public Feature {
    Q_OBJECT

public:
    explicit PlaybackControl(Stage& stage);

    [[nodiscard]] PlaybackPage& page() { return *page_; }
    /// Reads a run in the background, then shows its scene and its first tick; says in the window
    /// why that fails. @param file its folder, a file in it, or a bundle
    void look(const std::filesystem::path& file);
    /// Plays the last seconds of the live run in slow motion, from just before its last snap-in or
    /// pull-off; the window says where there was neither. There is a run.
    void replayLastJump();
    /// The run that is shown; null: the live one is.
    [[nodiscard]] const LookedAtRun* shown() const { return shown_.get(); }
    /// Returns whether a run is being read that will be shown.
    [[nodiscard]] bool isReading() const { return reading_.isAwaited(); }
    /// The tick that the views show; none: the first one is to come.
    [[nodiscard]] const std::optional<std::size_t>& tick() const { return tick_; }
    /// Once a frame: plays on. @param elapsed since the last frame [s]
    void advance(double elapsed);

Q_SIGNALS:
    /// A recording is shown.
    void begun();
    /// The live run is shown again.
    void ended();

private:
    using Run = std::shared_ptr<LookedAtRun>;

    /// Ticks up to the one that is shown next.
    struct Stretch {
        std::vector<TickSample> ticks;
        bool goesOn = false;     ///< they follow those that the panels had last
        bool isHistory = false;  ///< with those before the tick that is shown already
    };

    void addEntries();
    void show(const Run& run);
    void end();
    /// Has a tick shown, as soon as it is computed; of many, the last one.
    void want(std::size_t tick);
    void compute();
    void take(const Stretch& stretch);
    void showMoment(const TickSample& sample);
    void play(bool playing);
    void rewindPanels();

    PlaybackPage* page_;  ///< the window's
    Run shown_;
    QString title_;  ///< of the window without a recording
    std::optional<std::size_t> tick_;
    std::size_t wanted_ = 0;
    std::size_t awaited_ = 0;  ///< that is being computed
    bool hasHistory_ = false;  ///< the panels have what was before the tick
    bool playsSoon_ = false;   ///< once the panels have it
    bool playing_ = false;
    double time_ = 0.0;  ///< of what plays [s]
    LongWork<Run> reading_;
    BackgroundWork<Stretch> work_;
};

/// Overlays a second run on the recording that is looked at, with the difference of their forces.
class ComparisonControl : public Feature {
public:
    explicit ComparisonControl(Stage& stage);

    /// Reads a run in the background; says in the window why it cannot be compared. There is a
    /// recording. @param file its folder, a file in it, or a bundle
    void compareWith(const std::filesystem::path& file);
    /// Nothing comes of the run that is being read.
    void cancel() { work_.cancel(); }

private:
    void ask();
    void show(const ComparedRun& second);

    PlaybackControl& playback_;
    std::filesystem::path second_;  ///< asked for last
    LongWork<ComparedRun> work_;
};

}  // namespace asperity
