#include "app/window/device/PathControl.h"

#include "app/recording/RecordedRun.h"
#include "app/runs/RunFolder.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "core/Error.h"
#include "core/io/scene/DevicePathFile.h"
#include "core/words/BudgetWords.h"
#include "core/words/SceneWords.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ReadingBudget.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QFileDialog>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <optional>

namespace asperity {

namespace {

/// A path in other units than meters, or of a larger scan, would lead the tip far away, and take as
/// long. @param why it may do so
/// @throw InputError when the path leaves the scan by more than its width
void requireNear(const Scene& scene, const DevicePath& path, const std::string& file,
                 const std::string& why) {
    const double reach = 2.0 * std::max(scene.surface.sizeX(), scene.surface.sizeY());
    for (const PathPoint& point : path) {
        const Vector2 position = point.position.head<2>();
        if (!scene.surface.contains(position.x(), position.y()) && position.norm() > reach) {
            throw InputError(file, "at " + std::to_string(point.time) + " s",
                             "the path leaves the scan by more than its width: " + why);
        }
    }
}

constexpr const char* kInMeters = "x_m, y_m and z_m must be meters from its lower left corner";

/// Of a recording on another sample than that of the run, both: "recorded on ps.gwy, channel
/// Height; followed on steps.gsf, channel Height". Empty: it is the same, or nobody knows.
QString bothSamples(const LoadedScene& here, const std::filesystem::path& recording) {
    const std::optional<RecordedSample> recorded = sampleOf(recording);
    const SampleDescription& sample = here.scene.description.sample;
    const std::string name = sampleName(sample);
    const auto isSame = [&] {
        return recorded->sha256 == here.sha256 && recorded->channel == sample.channel &&
               recorded->crop == sample.crop && (!here.sha256.empty() || recorded->name == name);
    };
    return !recorded || isSame()
               ? QString()
               : PathControl::tr("recorded on %1; followed on %2")
                     .arg(QString::fromStdString(recorded->name), QString::fromStdString(name));
}

/// A path from above, thin enough to draw [m].
QPolygonF outline(const DevicePath& path) {
    constexpr std::size_t kPoints = 1000;
    QPolygonF way;
    const std::size_t step = 1 + path.size() / kPoints;
    for (std::size_t i = 0; i < path.size(); i += step) {
        way << QPointF(path[i].position.x(), path[i].position.y());
    }
    return way;
}

}  // namespace

PathControl::PathControl(Stage& stage) : Feature(stage), devices_(stage.get<DeviceControl>()) {
    QStringList names;
    for (const PlannedPath path : kValues<PlannedPath>) {
        names << QString::fromUtf8(nameOf(path));
    }
    live_.controls().setPaths(names);
    connect(&live_.controls(), &ControlBar::pathChosen, this, &PathControl::choose);
    connect(&devices_, &DeviceControl::pathWanted, this, [this] { choose(0); });
    addEntries();
}

void PathControl::addEntries() {
    Menus& menus = host_.menus();
    const auto refusal = [this] { return runs_.moveRefusal(); };
    const QAction& file = menus.add({MenuName::Run, 1, 10}, "followPathFile",
                                    {.text = tr("Follow a path from a fi&le…"),
                                     .tip = tr("Move the base along a path from a CSV file"),
                                     .refusal = refusal});
    const QAction& recording = menus.add({MenuName::Run, 1, 20}, "followRecording",
                                         {.text = tr("Replay a &recording…"),
                                          .tip = tr("Move the base as in a recorded run"),
                                          .refusal = refusal});
    const auto askForFile = [this] {
        const QString chosen = QFileDialog::getOpenFileName(
            &host_.widget(), tr("Follow a path"), {}, tr("Paths: time_s, x_m, y_m, z_m (*.csv)"));
        if (!chosen.isEmpty()) {
            followFile(chosen);
        }
    };
    connect(&file, &QAction::triggered, this, askForFile);
    connect(&live_.controls(), &ControlBar::pathFileRequested, this, askForFile);
    connect(&recording, &QAction::triggered, this, [this] {
        const QString chosen = QFileDialog::getOpenFileName(
            &host_.widget(), tr("Replay a recording"), {},
            tr("Force logs (%1 %2 *.csv)")
                .arg(QLatin1String(run_files::kLog), QLatin1String(run_files::kTables)));
        if (!chosen.isEmpty()) {
            replayRecording(chosen.toStdString());
        }
    });
}

void PathControl::followFile(const QString& file) { followFile(file, readDevicePath, kInMeters); }

void PathControl::follow(const DevicePath& path) {
    devices_.follow(path);
    live_.overview().showPath(outline(path));
}

void PathControl::approach(const PlannedApproach& approach) {
    devices_.approach(approach);
    live_.overview().showPath(outline({{0.0, approach.start}}));
}

void PathControl::choose(int index) {
    if (runs_.run() != nullptr) {
        const Vector2 here = runs_.run()->basePosition().head<2>();
        const Scene& scene = runs_.run()->scene();
        const PlannedPathRow& path = kEnumTable<PlannedPath>.at(static_cast<std::size_t>(index));
        live_.controls().setPath(index);
        if (path.plan != nullptr) {
            follow(path.plan(scene, {.position = here}));
        } else {
            approach(
                planApproach(scene, {.position = here, .setpoint = live_.engage().setpoint()}));
        }
    }
}

/// @return whether the device follows it
bool PathControl::followFile(const QString& file, const ReadPath& read, const std::string& whyFar) {
    if (runs_.run() == nullptr) {
        return false;
    }
    try {
        const DevicePath path = read(file.toStdString());
        requireNear(runs_.run()->scene(), path, file.toStdString(), whyFar);
        live_.controls().setPath(-1);
        follow(path);
        return true;
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
        return false;
    }
}

void PathControl::replayRecording(const std::filesystem::path& forceLog) {
    if (runs_.run() == nullptr) {
        return;
    }
    const std::filesystem::path folder = forceLog.parent_path();
    std::string cutOff;
    const auto read = [&](const std::filesystem::path& file) {
        cutOff = sentenceOf(stateOf(folder));  // may refuse it
        return readRecordedPath(readRunLog(file));
    };
    const QString both = bothSamples(runs_.run()->loaded(), folder);
    if (!followFile(QString::fromStdString(forceLog.string()), read,
                    both.isEmpty() ? kInMeters : both.toStdString())) {
        return;
    }
    QStringList words;
    if (!both.isEmpty()) {
        words << tr("Another scan: %1").arg(both);
    }
    if (!cutOff.empty()) {
        words << QString::fromStdString(cutOff);
    }
    if (!words.isEmpty()) {
        host_.tell(words.join(QStringLiteral(" · ")));
    }
}

namespace {

/// Returns how an approach ended. One step may carry the tip past the setpoint, by a jump or on a
/// stiff sample: the force is the one that was there.
QString wordsOn(const Scene& scene, const ApproachDevice& approach, const QString& setpoint) {
    if (approach.hasEngaged()) {
        const Budget force =
            shownForce(&scene, approach.measuredForce(), approach.measuredDeviation());
        return QObject::tr("Engaged at %1 (setpoint %2)")
            .arg(QString::fromStdString(budgetText(force, "N")), setpoint);
    }
    return approach.isBlocked()
               ? QObject::tr("Not engaged: no equilibrium of tip and cantilever below here")
               : QObject::tr("Not engaged: the force did not reach %1").arg(setpoint);
}

}  // namespace

EngageControl::EngageControl(Stage& stage) : Feature(stage), devices_(stage.get<DeviceControl>()) {
    stage.onFrame(FrameStep::Move, [this](double /*elapsed*/) { advance(); });
    EngageBar& bar = live_.engage();
    connect(&bar, &EngageBar::engageChosen, this, &EngageControl::engage);
    connect(&bar, &EngageBar::withdrawChosen, this, &EngageControl::withdraw);
    connect(&bar, &EngageBar::setpointChanged, this, &EngageControl::setSetpoint);
    connect(&runs_, &RunControl::ending, this, [this] { engaging_ = withdrawing_ = false; });
    connect(&runs_, &RunControl::begun, this, &EngageControl::showSetpoint);
    connect(&edits_, &SceneEdits::changed, this, &EngageControl::showSetpoint);
}

void EngageControl::setSetpoint(double force) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.setpoint = force;
        edits_.change(tr("Setpoint: %1").arg(siText(force, "N")), next,
                      QStringLiteral("setpoint_n"));
    }
}

void EngageControl::showSetpoint() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        live_.engage().setSetpoint(scene->setpoint);
    }
}

void EngageControl::engage() {
    if (runs_.run() != nullptr) {
        asked_ = live_.engage().setpoint();
        devices_.engage(asked_);
        engaging_ = true;
        withdrawing_ = false;
    }
}

void EngageControl::withdraw() {
    if (runs_.run() != nullptr) {
        engaging_ = false;
        withdrawing_ = true;
        devices_.withdraw();
        host_.tell(tr("Withdrawing"));
    }
}

void EngageControl::followWithdrawal() {
    if (!withdrawing_ || devices_.isTraveling()) {
        return;
    }
    withdrawing_ = false;
    const TipRegion region = runs_.run()->loop().snapshot().sample.output.region();
    host_.tell(region == TipRegion::Far ? tr("Withdrawn")
                                        : tr("Not withdrawn: the tip was taken by hand"));
}

void EngageControl::advance() {
    followWithdrawal();
    const QString hidden = runs_.tipRefusal();
    const bool isCoupled = runs_.run()->coupling().coupled() != nullptr;
    live_.engage().setRefusals(hidden.isEmpty() && isCoupled
                                   ? tr("The operator approaches with the force-feedback device")
                                   : hidden,
                               hidden);
    const ApproachDevice* const approach = devices_.approaching();
    if (!engaging_ || approach == nullptr) {
        engaging_ = false;
        return;
    }
    const ApproachPhase phase = approach->phase();
    const bool isMeasured = phase == ApproachPhase::Dwell && approach->hasMeasured();
    if (isMeasured || phase == ApproachPhase::Done) {
        engaging_ = false;
        const QString words = wordsOn(runs_.run()->scene(), *approach, siText(asked_, "N"));
        devices_.releaseApproach();  // and with it the approach ends
        host_.tell(words);
    }
}

}  // namespace asperity
