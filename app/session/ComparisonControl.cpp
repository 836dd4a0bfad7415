#include "app/session/ComparisonControl.h"

#include "app/recording/RunComparison.h"
#include "app/recording/RunPlace.h"
#include "core/Error.h"
#include "ui/NumberText.h"
#include "ui/playback/ThinnedLine.h"
#include "ui/window/Dialogs.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

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

ComparisonControl::ComparisonControl(MainWindow& window, PlaybackControl& playback)
    : window_(window)
    , playback_(playback)
    , work_(loadingLine(window), {.finished = [this](ComparedRun& second) { show(second); },
                                  .failed =
                                      [this](const std::exception_ptr& reason) {
                                          window_.complain(reasonOf(reason));
                                      }}) {
    const PlaybackBar& bar = playback.page().bar();
    connect(&bar, &PlaybackBar::compareRequested, this, &ComparisonControl::ask);
    connect(&bar, &PlaybackBar::endComparisonRequested, this,
            [this] { playback_.page().setComparison(std::nullopt); });
    connect(&playback, &PlaybackControl::ended, this, &ComparisonControl::cancel);
}

void ComparisonControl::ask() {
    const QString file = askForRun(&window_);
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
        const auto names = runNames(first.input, second_);
        PlaybackPage::Comparison page = pageOf(forces, trace.begin());
        page.name = QString::fromStdString(names.first);
        page.other = curvesOf(second.trace, QString::fromStdString(names.second),
                              trace.begin() - second.trace.begin());
        for (const std::string& words : differencesOf(first.conditions, second.conditions)) {
            page.differs << QString::fromStdString(words);
        }
        if (!second.note.empty()) {
            window_.tell(QString::fromStdString(names.second + ": " + second.note));
        }
        playback_.page().setComparison(page);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
}

}  // namespace asperity
