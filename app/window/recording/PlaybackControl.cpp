#include "app/window/recording/PlaybackControl.h"

#include "app/exports/RunMoment.h"
#include "app/loading/ComparedRun.h"
#include "app/recording/Bundle.h"
#include "app/recording/RunComparison.h"
#include "app/runs/RunFolder.h"
#include "app/window/UnpackedRun.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/StateBanner.h"
#include "core/Error.h"
#include "ui/plot/CurveHistory.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/shell/RunPanel.h"
#include "ui/widgets/ReadingBudget.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Steady.h"

#include <QAction>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// What the panels are shown before a moment, so that their curves are those of the live run.
constexpr std::size_t kHistory = 10'000;
constexpr std::size_t kAtOnce = 1'000;     ///< that the curves go on by; more are another time
constexpr double kUnpacked = 0.1;          ///< share of the time that a bundle takes
constexpr double kLoaded = 0.3;            ///< the same with reading the run
constexpr int kPlottedStretches = 50'000;  ///< of a line: a zoom by ten still shows all

/// Reads a run and replays it once, so that any tick is available.
void read(LookedAtRun& run, Progress& progress) {
    ProgressPart unpacking(&progress, 0.0, kUnpacked);
    ProgressPart loading(&progress, kUnpacked, kLoaded);
    ProgressPart running(&progress, kLoaded, 1.0);
    const std::filesystem::path folder = unpackedRun(run.input, &unpacking);
    RunWithScene read =
        readStaying(run.input, folder, [&] { return readRunWithScene(folder, &loading); });
    run.note = std::move(read.note);
    run.loaded = std::make_shared<const LoadedScene>(std::move(read.loaded));
    run.playback.emplace(run.loaded->scene, std::move(read.run.inputs));
    run.conditions = conditionsOf(*run.loaded);
    run.survey = surveyOf(*run.playback, &running);
}

constexpr double kLead = 0.2;  ///< before a jump that is played again [s]

/// The name of a run for people.
QString nameOf(const LookedAtRun& run) {
    return run.input.empty() ? PlaybackControl::tr("last 10 s")
                             : QString::fromStdString(runName(run.input));
}

/// Returns the message with which a run is opened.
QString wordsOn(const LookedAtRun& run) {
    if (run.input.empty()) {
        return PlaybackControl::tr("The last 10 s in slow motion; the live run is paused");
    }
    const QString name = nameOf(run);
    return run.note.empty() ? PlaybackControl::tr("Recording %1: the live run is paused").arg(name)
                            : PlaybackControl::tr("Recording %1: %2")
                                  .arg(name, QString::fromStdString(run.note));
}

PlaybackBar::Steps stepsOf(const LookedAtRun& run) {
    const auto tickOf = [&run](NamedMoment moment) {
        const auto sample = sampleOf(run.survey.events, moment);
        return sample ? std::optional(static_cast<int>(run.playback->tickAt(sample->time)))
                      : std::nullopt;
    };
    return {0, tickOf(NamedMoment::SnapIn), tickOf(NamedMoment::Deepest),
            tickOf(NamedMoment::PullOff), static_cast<int>(run.playback->size()) - 1};
}

QString distanceText(const ContactState& contact) {
    const bool isApart = contact.region() != TipRegion::Contact;
    const bool isAbove = isApart || contact.indentation < 0.0;
    const QString name = isApart                     ? PlaybackControl::tr("gap")
                         : contact.indentation < 0.0 ? PlaybackControl::tr("neck height")
                                                     : PlaybackControl::tr("indentation");
    const double length = isAbove ? -contact.indentation : contact.indentation;
    return name + QLatin1Char(' ') + siText(length, "m");
}

/// The force with noise, model and calibration together, as the panel beside it.
PlaybackPage::Readings readingsOf(const Scene& scene, const TickSample& sample) {
    const TickOutput& output = sample.output;
    const double force = normalForce(output);
    const double sigma = shownForce(&scene, force, normalForceSigma(output)).total();
    const SiScale scale = siScaleFor(std::max(std::abs(force), sigma), "N");
    const QString state = output.fault == Fault::None ? coreWords(nameOf(output.region()))
                                                      : coreWords(nameOf(output.fault));
    return {.time = QStringLiteral("%1 s").arg(sample.time, 0, 'f', 3),
            .force = QStringLiteral("%1 ± %2").arg(
                QString::fromStdString(threeDigitText(force, SiScale{scale.factor, ""})).trimmed(),
                QString::fromStdString(threeDigitText(sigma, scale))),
            .distance = distanceText(output.model.contact),
            .state = state};
}

constexpr int kComparedStretches = 50'000;

QString forceText(double newtons) { return siText(newtons, "N"); }

/// @param begin of the first run [s]
PlaybackPage::Comparison pageOf(const RunComparison& forces, double begin) {
    PlaybackPage::Comparison page;
    QVector<QPointF> difference;
    for (const ComparedForces& tick : forces.ticks) {
        difference.append({begin + tick.time, tick.difference()});
    }
    page.difference = thinned(difference, 0, difference.size(), kComparedStretches);
    page.mean = forceText(forces.mean);
    page.rms = forceText(forces.rms);
    page.largest = ComparisonControl::tr("%1 at %2 s")
                       .arg(forceText(forces.largest.difference()))
                       .arg(begin + forces.largest.time, 0, 'f', 3);
    page.overlap = ComparisonControl::tr("%1 s, %2 ticks")
                       .arg(forces.overlap, 0, 'f', 3)
                       .arg(forces.ticks.size());
    if (forces.excluded > 0) {
        page.overlap += ComparisonControl::tr(", %1 left out").arg(forces.excluded);
    }
    return page;
}

}  // namespace

QString askForRun(QWidget& window, const QString& title) {
    const QStringList files{run_files::kManifest, run_files::kSummary, run_files::kTables,
                            run_files::kLog};
    return askWhatToOpen(
        &window,
        {.kind = FileKind::Recording,
         .title = title,
         .filters = PlaybackControl::tr("Recorded runs (%1);;Bundles (*.zip);;All files (*)")
                        .arg(files.join(QLatin1Char(' ')))});
}

PlaybackPage::Curves curvesOf(const ForceTrace& trace, const QString& name, double shift) {
    QVector<QPointF> force;
    QVector<QPointF> distance;
    force.reserve(static_cast<int>(trace.size()));
    distance.reserve(static_cast<int>(trace.size()));
    for (std::size_t tick = 0; tick < trace.size(); ++tick) {
        force.append({trace.time()[tick] + shift, trace.force()[tick]});
        distance.append({trace.indentation()[tick], trace.force()[tick]});
    }
    return {.name = name,
            .force = thinned(force, 0, force.size(), kPlottedStretches),
            .distance = thinned(distance, 0, distance.size(), kPlottedStretches)};
}

PlaybackControl::PlaybackControl(Stage& stage)
    : Feature(stage)
    , page_(new PlaybackPage(&host_.widget()))
    , reading_(loadingLine(host_),
               {.finished = [this](Run& run) { show(run); }, .failed = complaintIn(host_)})
    , work_({.progressed = [](double /*fraction*/) {},
             .finished = [this](Stretch& stretch) { take(stretch); },
             .failed = complaintIn(host_)}) {
    stage.onFrame(FrameStep::Act, [this](double elapsed) { advance(elapsed); });
    host_.addTool(page_, tr("Recording"));
    addEntries();
    const PlaybackBar& bar = page_->bar();
    connect(&bar, &PlaybackBar::tickChosen, this, [this](int tick) {
        if (shown_) {
            playsSoon_ = false;
            time_ = shown_->playback->time(static_cast<std::size_t>(tick));
            want(static_cast<std::size_t>(tick));
        }
    });
    connect(&bar, &PlaybackBar::playingChosen, this, &PlaybackControl::play);
    connect(&bar, &PlaybackBar::backRequested, &runs_, &RunControl::showLive);
    connect(&runs_, &RunControl::liveShown, this, &PlaybackControl::end);
}

void PlaybackControl::addEntries() {
    const QAction& entry =
        host_.menus().add({MenuName::Run, 1, 30}, "lookAtRecording",
                          {.text = tr("Look at a rec&ording…"),
                           .tip = tr("Show any moment of a recorded run, or of a bundle, in all "
                                     "views"),
                           .refusal = [this] { return runs_.fixedBy(); }});
    connect(&entry, &QAction::triggered, this, [this] {
        const QString file = askForRun(host_.widget(), tr("Look at a recording"));
        if (!file.isEmpty()) {
            look(file.toStdString());
        }
    });
    QAction& replay =
        host_.menus().add({MenuName::Run, 1, 40}, "replayLastJump",
                          {.text = tr("Replay the last snap-&in or pull-off"),
                           .tip = tr("Play the last 10 s of the run ten times slower, from just "
                                     "before its last snap-in or pull-off"),
                           .shortcuts = {tr("Ctrl+Shift+R")},
                           .refusal = [this] { return runs_.moveRefusal(); }});
    replay.setIconText(tr("Last snap-in or pull-off"));
    connect(&replay, &QAction::triggered, this, &PlaybackControl::replayLastJump);
    page_->bar().addReplay(replay);
}

void PlaybackControl::look(const std::filesystem::path& file) {
    if (!runs_.fixedBy().isEmpty()) {
        host_.tell(runs_.fixedBy());
        return;
    }
    const auto run = std::make_shared<LookedAtRun>();
    run->input = runOf(file);
    reading_.start(tr("Reading %1 …").arg(nameOf(*run)), [run](Progress& progress) {
        read(*run, progress);
        return run;
    });
}

/// The live run goes on while its ticks are replayed once.
void PlaybackControl::replayLastJump() {
    runs_.fetch();
    const BlackBox& box = runs_.run()->blackBox();
    const std::optional<std::size_t> jump = lastJump(box);
    if (!jump) {
        host_.tell(tr("There was no snap-in or pull-off in the last 10 s"));
        return;
    }
    const auto run = std::make_shared<LookedAtRun>();
    run->loaded = runs_.run()->shared();
    run->conditions = conditionsOf(*run->loaded);
    run->playback.emplace(run->loaded->scene, box);
    run->first = run->playback->tickAt(run->playback->time(*jump) - kLead);
    reading_.start(tr("Reading the last 10 s …"), [run](Progress& progress) {
        run->survey = surveyOf(*run->playback, &progress);
        return run;
    });
}

void PlaybackControl::show(const Run& run) {
    edits_.cancel();
    if (runs_.run() == nullptr) {
        runs_.use(LoadedScene(*run->loaded));
    }
    runs_.showRecording(run->loaded, run->input, run->playback->at(run->first));
    shown_ = run;
    title_ = host_.widget().windowTitle();
    tick_ = wanted_ = run->first;
    hasHistory_ = false;
    playsSoon_ = run->input.empty();
    time_ = run->playback->time(run->first);
    page_->setRun(static_cast<int>(run->playback->size()), stepsOf(*run),
                  curvesOf(run->survey.trace, nameOf(*run)));
    page_->bar().setSlow(run->input.empty());
    host_.showTool(page_);
    host_.tell(wordsOn(*run));
    rewindPanels();
    showMoment(runs_.shown().sample);
    compute();
    Q_EMIT begun();
}

void PlaybackControl::end() {
    if (!shown_) {
        return;
    }
    work_.cancel();
    shown_.reset();
    tick_.reset();
    play(false);
    live_.banner().setRecorded(std::nullopt);
    rewindPanels();
    page_->setRun(0, {}, {});
    host_.hideTool(page_);
    Q_EMIT ended();
}

void PlaybackControl::rewindPanels() {
    for (RunPanel* const panel : live_.panels()) {
        panel->rewind();
    }
}

void PlaybackControl::play(bool playing) {
    playsSoon_ = false;
    playing_ = playing && shown_ != nullptr;
    if (playing_ && wanted_ + 1 >= shown_->playback->size()) {
        time_ = shown_->playback->firstTime();  // once more
    }
    page_->bar().setPlaying(playing_);
    if (shown_) {
        runs_.setPlaying(playing_ ? page_->bar().speed() : 0.0);
    }
}

void PlaybackControl::advance(double elapsed) {
    if (!playing_) {
        return;
    }
    runs_.setPlaying(page_->bar().speed());
    time_ += elapsed * page_->bar().speed();
    if (time_ >= shown_->playback->lastTime()) {
        time_ = shown_->playback->lastTime();
        play(false);
    }
    want(shown_->playback->tickAt(time_));
}

void PlaybackControl::want(std::size_t tick) {
    wanted_ = tick;
    if (!work_.isBusy() || tick_ == awaited_) {  // what only completes the curves can wait
        compute();
    }
}

/// While somebody scrubs, only the ticks wanted; then those before the last one.
void PlaybackControl::compute() {
    const bool isShown = tick_ == wanted_;
    if (isShown && hasHistory_) {
        return;
    }
    const bool goesOn = tick_ && wanted_ > *tick_ && wanted_ - *tick_ <= kAtOnce;
    const std::size_t first =
        goesOn ? *tick_ + 1 : wanted_ - (isShown ? std::min(wanted_, kHistory) : 0);
    awaited_ = wanted_;
    work_.start([run = shown_, first, last = wanted_, goesOn, isShown](Progress& progress) {
        Stretch stretch{.ticks = {}, .goesOn = goesOn, .isHistory = isShown};
        stretch.ticks.reserve(last - first + 1);
        run->playback->play(first, [&](const TickSample& sample) {
            stretch.ticks.push_back(sample);
            if (progress.isCanceled()) {
                throw Canceled();
            }
            return stretch.ticks.size() <= last - first;
        });
        return stretch;
    });
}

void PlaybackControl::take(const Stretch& stretch) {
    if (!stretch.goesOn) {
        rewindPanels();
        hasHistory_ = stretch.isHistory;
    }
    for (RunPanel* const panel : live_.panels()) {
        std::ranges::for_each(stretch.ticks,
                              [panel](const TickSample& sample) { panel->take(sample); });
    }
    tick_ = awaited_;
    runs_.showRecorded(stretch.ticks, stretch.goesOn);
    showMoment(runs_.shown().sample);  // the force that is shown elsewhere, too
    compute();
    if (stretch.isHistory && playsSoon_) {
        play(true);
    }
}

void PlaybackControl::showMoment(const TickSample& sample) {
    live_.banner().setRecorded(sample.time);
    host_.widget().setWindowTitle(
        tr("Recording, t = %1 s – %2").arg(sample.time, 0, 'f', 3).arg(title_));
    page_->showMoment(static_cast<int>(*tick_), readingsOf(runs_.scene(), sample), sample.time,
                      sample.output.model.contact.indentation, normalForce(sample.output));
}

ComparisonControl::ComparisonControl(Stage& stage)
    : Feature(stage)
    , playback_(stage.get<PlaybackControl>())
    , work_(loadingLine(host_), {.finished = [this](ComparedRun& second) { show(second); },
                                 .failed = complaintIn(host_)}) {
    const PlaybackBar& bar = playback_.page().bar();
    connect(&bar, &PlaybackBar::compareRequested, this, &ComparisonControl::ask);
    connect(&bar, &PlaybackBar::endComparisonRequested, this,
            [this] { playback_.page().setComparison(std::nullopt); });
    connect(&playback_, &PlaybackControl::ended, this, &ComparisonControl::cancel);
}

void ComparisonControl::ask() {
    const QString file = askForRun(host_.widget(), tr("Compare with a recording"));
    if (!file.isEmpty() && playback_.shown() != nullptr) {
        compareWith(file.toStdString());
    }
}

void ComparisonControl::compareWith(const std::filesystem::path& file) {
    second_ = runOf(file);
    const QString name = QString::fromStdString(runName(second_));
    work_.start(tr("Reading %1 …").arg(name),
                [run = second_](Progress& progress) { return readComparedRun(run, &progress); });
}

void ComparisonControl::show(const ComparedRun& second) {
    const LookedAtRun& first = *playback_.shown();
    const ForceTrace& trace = first.survey.trace;
    try {
        const RunComparison forces = compareRuns(trace, second.trace);
        auto names = runNames(first.input, second_);
        if (first.input.empty()) {
            names.first = nameOf(first).toStdString();
        }
        PlaybackPage::Comparison page = pageOf(forces, trace.begin());
        page.name = QString::fromStdString(names.first);
        page.other = curvesOf(second.trace, QString::fromStdString(names.second),
                              trace.begin() - second.trace.begin());
        for (const std::string& words : differencesOf(first.conditions, second.conditions)) {
            page.differs << QString::fromStdString(words);
        }
        if (!second.note.empty()) {
            host_.tell(QString::fromStdString(names.second + ": " + second.note));
        }
        playback_.page().setComparison(page);
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
    }
}

}  // namespace asperity
