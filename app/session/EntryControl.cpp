#include "app/session/EntryControl.h"

#include "ui/window/MainWindow.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

namespace {

/// Empty where it works.
QString unless(bool works, const QString& reason) { return works ? QString() : reason; }

}  // namespace

EntryControl::EntryControl(MainWindow& window, const RunControl& runs, const DeviceControl& devices,
                           const SceneEdits& edits)
    : window_(window), runs_(runs), devices_(devices), edits_(edits) {
    show();
}

void EntryControl::show() {
    showThoseOfARun();
    showThoseOfADevice();
    showThoseOfTheScene();
    window_.menus().setHistory(edits_.undoName(), edits_.redoName());
}

void EntryControl::showThoseOfARun() {
    WindowMenus& menus = window_.menus();
    LiveRun* const run = runs_.run();
    const QString noRun = unless(run != nullptr, QObject::tr("Open a scan or a scene first"));
    for (QAction* const entry : {menus.aboutScan, menus.exportView, menus.saveLastSeconds,
                                 menus.bundle, menus.copyNumbers, menus.study}) {
        menus.refuse(*entry, noRun);
    }
    const QString fixed = noRun.isEmpty() ? runs_.fixedBy() : noRun;
    for (QAction* const entry :
         {menus.record, menus.saveSession, menus.saveSessionAs, menus.startPause, menus.tipControl,
          menus.clutch, menus.measure().forceMap}) {
        menus.refuse(*entry, fixed);
    }
    for (QAction* const entry : {menus.followPathFile, menus.followRecording}) {
        menus.refuse(*entry, fixed.isEmpty() ? runs_.tipRefusal() : fixed);
    }
    const bool isFaulty =
        run != nullptr && run->loop().snapshot().sample.output.fault != Fault::None;
    menus.refuse(*menus.resetFault, unless(isFaulty, QObject::tr("There is no fault to reset")));
}

void EntryControl::showThoseOfADevice() {
    WindowMenus& menus = window_.menus();
    LiveRun* const run = runs_.run();
    menus.refuse(
        *menus.followsView,
        unless(run != nullptr && devices_.hasHardware(),
               QObject::tr("Mouse and keyboard follow the view already; for other devices only")));
    menus.refuse(
        *menus.calibrate,
        unless(run != nullptr && run->device().specification().calibrates,
               QObject::tr("This device needs no calibration: it has no encoders to zero")));
    menus.refuseGuides(
        !runs_.fixedBy().isEmpty()
            ? runs_.fixedBy()
            : unless(run != nullptr && run->settings().coupling.couples(),
                     QObject::tr(
                         "A guide needs a coupling: a force-feedback device's or the scene's")));
}

void EntryControl::showThoseOfTheScene() {
    WindowMenus& menus = window_.menus();
    ViewOptionsMenu& options = menus.viewOptions();
    for (QAction* const entry :
         {menus.open, menus.lookAtRecording, &options.action(&ViewOptions::deformation),
          &options.action(&ViewOptions::trueTip)}) {
        menus.refuse(*entry, runs_.fixedBy());
    }
    menus.refuse(*menus.secondView, options.options().deformation ? QString() : runs_.fixedBy());
}

}  // namespace asperity
