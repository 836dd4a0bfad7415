#include "app/session/MeasureControl.h"

#include "core/io/TextValue.h"
#include "core/words/SceneWords.h"
#include "ui/measure/ForceMapPage.h"
#include "ui/measure/MarkersPage.h"
#include "ui/measure/ProfilePage.h"
#include "ui/measure/TouchesPage.h"
#include "ui/panels/OverviewMap.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/window/MainWindow.h"
#include "ui/window/MeasureMenu.h"
#include "ui/window/WindowLayout.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

namespace {

/// Two surfaces with the same key are the same piece of a sample, whatever was done to its heights.
std::string scanKey(const Scene& scene) {
    const BSplineSurface::Grid& grid = scene.surface.grid();
    return sampleName(scene.description.sample) + " " + exactText(grid.pitchX) + " " +
           exactText(grid.pitchY) + " " + std::to_string(grid.columns) + " " +
           std::to_string(grid.rows);
}

}  // namespace

MeasureControl::MeasureControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window)
    , runs_(runs)
    , profile_(window, runs)
    , roughness_(window, runs)
    , forceMaps_(window, runs)
    , markers_(window, runs, edits)
    , touches_(window, runs)
    , curves_(window, runs, *window.findChild<CyclePanel*>()) {
    leaving_.setSingleShot(true);
    leaving_.setInterval(0);
    connect(&runs, &RunControl::begun, this, &MeasureControl::begin);
    connectMenu();
}

void MeasureControl::connectMenu() {
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    const MeasureMenu& menu = window_.menus().measure();
    const auto open = [this](QWidget& page) {
        window_.showTool(&page);
        window_.layout().showCards();  // the whole scan is there, where tools mark and are drawn
    };
    on(menu.profile, [this, open] {
        open(profile_.page());
        profile_.page().setDrawing(true);
    });
    on(menu.roughness, [this, open] { open(roughness_.page()); });
    on(menu.forceMap, [this, open] { open(forceMaps_.page()); });
    on(menu.markers, [this, open] { open(markers_.page()); });
    on(menu.markerHere, [this] { markers_.addAtCrossHair(); });
    on(menu.touches, [this, open] { open(touches_.page()); });
    on(menu.curve, [this] { curves_.ask(); });
}

void MeasureControl::begin() {
    const std::string key = scanKey(runs_.run()->scene());
    if (std::exchange(scan_, key) != key) {
        profile_.forget();
        roughness_.forget();
        forceMaps_.forget();
    } else {
        profile_.refresh();
        roughness_.refresh();
        forceMaps_.refresh();
    }
}

bool MeasureControl::leaveTool() {
    OverviewMap& map = window_.overview().map();
    if (map.activeTool() != nullptr) {
        map.activate(nullptr);
        leaving_.start();
    }
    return leaving_.isActive();
}

}  // namespace asperity
