#include "app/session/PathControl.h"

#include "app/recording/RecordedRun.h"
#include "core/Error.h"
#include "core/io/scene/DevicePathFile.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/EngageBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/MainWindow.h"

#include <QPolygonF>

#include <algorithm>
#include <array>

namespace asperity {

namespace {

struct PlannedPath {
    const char* name;
    DevicePath (*plan)(const Scene&, const PathPlan&);  ///< null: an approach to the setpoint
};

constexpr std::array<PlannedPath, 4> kPaths{{{"Approach", nullptr},
                                             {"Slide", slidePath},
                                             {"Raster", rasterPath},
                                             {"Scratch", scratchPath}}};

/// A path in other units than meters would lead the tip far away, and take as long.
/// @throw InputError when the path leaves the scan by more than its width
void requireNear(const Scene& scene, const DevicePath& path, const std::string& file) {
    const double reach = 2.0 * std::max(scene.surface.sizeX(), scene.surface.sizeY());
    for (const PathPoint& point : path) {
        const Vector2 place = point.position.head<2>();
        if (!scene.surface.contains(place.x(), place.y()) && place.norm() > reach) {
            throw InputError(file, "at " + std::to_string(point.time) + " s",
                             "the path leaves the scan by more than its width: x_m, y_m and z_m "
                             "must be meters from its lower left corner");
        }
    }
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
    for (const PlannedPath& path : kPaths) {
        names << tr(path.name);
    }
    window.controls().setPaths(names);
    connect(&window.controls(), &ControlBar::pathChosen, this, &PathControl::choose);
    connect(&devices, &DeviceControl::pathWanted, this, [this] { choose(0); });
    connect(&window, &MainWindow::pathFileChosen, this,
            [this](const QString& file) { followFile(file, readDevicePath); });
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
        const PlannedPath& path = kPaths.at(static_cast<std::size_t>(index));
        window_.controls().setPath(index);
        if (path.plan != nullptr) {
            follow(path.plan(scene, {.place = here}));
        } else {
            approach(planApproach(scene, {.place = here, .setpoint = window_.engage().setpoint()}));
        }
    }
}

/// @return whether the device follows it
bool PathControl::followFile(const QString& file, const ReadPath& read) {
    if (runs_.run() == nullptr) {
        return false;
    }
    try {
        const DevicePath path = read(file.toStdString());
        requireNear(runs_.run()->scene(), path, file.toStdString());
        window_.controls().setPath(-1);
        follow(path);
        return true;
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        return false;
    }
}

void PathControl::replayRecording(const std::filesystem::path& forceLog) {
    const auto read = [](const std::filesystem::path& file) {
        return readRecordedPath(readRunTable(file));
    };
    if (followFile(QString::fromStdString(forceLog.string()), read)) {
        const std::string cutOff = sentenceOf(stateOf(forceLog.parent_path()));
        if (!cutOff.empty()) {
            window_.tell(QString::fromStdString(cutOff));
        }
    }
}

}  // namespace asperity
