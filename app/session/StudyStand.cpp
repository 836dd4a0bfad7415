#include "app/session/StudyStand.h"

#include "core/haptics/DevicePath.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

StudyStand::StudyStand(MainWindow& window, RunControl& runs)
    : window_(window)
    , runs_(runs)
    , scene_(runs.run()->shared())
    , place_(runs.run()->basePosition().head<2>())
    , settings_(runs.run()->sensingSettings())
    , scale_{.positionGain = runs.run()->settings().positionGain,
             .forceGain = runs.run()->settings().forceGain}
    , options_(window.menus().viewOptions().options())
    , hasSecondView_(window.menus().secondView->isChecked())
    , halfWidth_(window.view().halfWidth())
    , azimuth_(window.view().camera().azimuth())
    , elevation_(window.view().camera().elevation()) {}

void StudyStand::restore() const {
    runs_.place(LoadedScene(*scene_), waitingPlace(scene_->scene, place_), settings_);
    if (runs_.run()->coupling().coupled() != nullptr) {
        runs_.turn([this](Settings& settings) {
            settings.positionGain = scale_.positionGain;
            settings.forceGain = scale_.forceGain;
        });
    }
    window_.menus().viewOptions().setOptions(options_);
    window_.view().setOptions(options_);
    window_.menus().secondView->setChecked(hasSecondView_);
    window_.view().setHalfWidth(halfWidth_);
    window_.view().setDirection(azimuth_, elevation_);
}

}  // namespace asperity
