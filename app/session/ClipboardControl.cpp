#include "app/session/ClipboardControl.h"

#include "ui/panels/CopyablePlot.h"
#include "ui/panels/RunPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCursor>
#include <QImage>
#include <QPixmap>

namespace asperity {

namespace {

/// The plot under the pointer, else the one that has the focus; null: none.
CopyablePlot* meantPlot() {
    if (CopyablePlot* plot = CopyablePlot::of(QApplication::widgetAt(QCursor::pos()))) {
        return plot;
    }
    return CopyablePlot::of(QApplication::focusWidget());
}

}  // namespace

ClipboardControl::ClipboardControl(MainWindow& window, RunControl& runs, ViewControl& views)
    : window_(window), runs_(runs), views_(views) {
    const WindowMenus& menus = window.menus();
    connect(menus.copyView, &QAction::triggered, this, &ClipboardControl::copyView);
    connect(menus.copyWindow, &QAction::triggered, this, &ClipboardControl::copyWindow);
    connect(menus.copyPlot, &QAction::triggered, this, &ClipboardControl::copyPlot);
    connect(menus.copyNumbers, &QAction::triggered, this, &ClipboardControl::copyNumbers);
}

void ClipboardControl::copyView() {
    // Of the second view where that has the focus.
    auto* const focused = qobject_cast<ZoomView*>(QApplication::focusWidget());
    ZoomView& view = focused != nullptr ? *focused : window_.view();
    QApplication::clipboard()->setImage(view.grab().toImage());
    window_.tell(tr("The view is on the clipboard"));
}

void ClipboardControl::copyWindow() {
    QApplication::clipboard()->setImage(views_.picture().toImage());
    window_.tell(tr("The window is on the clipboard"));
}

void ClipboardControl::copyPlot() {
    const CopyablePlot* const plot = meantPlot();
    if (plot == nullptr) {
        window_.tell(
            tr("Which plot? Point at one and press %1, or use its context menu")
                .arg(window_.menus().copyPlot->shortcut().toString(QKeySequence::NativeText)));
        return;
    }
    plot->copy();
    window_.tell(tr("The plot is on the clipboard"));
}

void ClipboardControl::copyNumbers() {
    if (runs_.run() == nullptr) {
        return;
    }
    const Snapshot& latest = runs_.shown();
    ShownNumbers numbers;
    for (const RunPanel* const panel : window_.panels()) {
        const ShownNumbers own = panel->numbers(latest);
        numbers.insert(numbers.end(), own.begin(), own.end());
    }
    QApplication::clipboard()->setText(tabSeparated(numbers));
    window_.tell(tr("%1 readings are on the clipboard").arg(numbers.size()));
}

}  // namespace asperity
