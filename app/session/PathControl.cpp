#include "app/session/PathControl.h"

#include "app/recording/RecordedRun.h"
#include "core/Error.h"
#include "core/io/scene/DevicePathFile.h"
#include "core/words/SceneWords.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/EngageBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/MainWindow.h"

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
        const Vector2 place = point.position.head<2>();
        if (!scene.surface.contains(place.x(), place.y()) && place.norm() > reach) {
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

PathControl::PathControl(MainWindow& window, RunControl& runs, DeviceControl& devices)
    : window_(window), runs_(runs), devices_(devices) {
    QStringList names;
    for (const PlannedPath path : kValues<PlannedPath>) {
        names << QString::fromUtf8(nameOf(path));
    }
    window.controls().setPaths(names);
    connect(&window.controls(), &ControlBar::pathChosen, this, &PathControl::choose);
    connect(&devices, &DeviceControl::pathWanted, this, [this] { choose(0); });
    connect(&window, &MainWindow::pathFileChosen, this,
            [this](const QString& file) { followFile(file, readDevicePath, kInMeters); });
    connect(&window, &MainWindow::recordingChosen, this,
            [this](const QString& file) { replayRecording(file.toStdString()); });
}

void PathControl::follow(const DevicePath& path) {
    devices_.follow(path);
    window_.overview().showPath(outline(path));
}

void PathControl::approach(const PlannedApproach& approach) {
    devices_.approach(approach);
    window_.overview().showPath(outline({{0.0, approach.start}}));
}

void PathControl::choose(int index) {
    if (runs_.run() != nullptr) {
        const Vector2 here = runs_.run()->basePosition().head<2>();
        const Scene& scene = runs_.run()->scene();
        const PlannedPathRow& path = kEnumTable<PlannedPath>.at(static_cast<std::size_t>(index));
        window_.controls().setPath(index);
        if (path.plan != nullptr) {
            follow(path.plan(scene, {.place = here}));
        } else {
            approach(planApproach(scene, {.place = here, .setpoint = window_.engage().setpoint()}));
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
        window_.controls().setPath(-1);
        follow(path);
        return true;
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
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
        window_.tell(words.join(QStringLiteral(" · ")));
    }
}

}  // namespace asperity
