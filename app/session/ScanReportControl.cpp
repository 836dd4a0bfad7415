#include "app/session/ScanReportControl.h"

#include "app/program/ScanReport.h"
#include "ui/window/MainWindow.h"
#include "ui/window/TextDialog.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

ScanReportControl::ScanReportControl(MainWindow& window, const RunControl& runs)
    : window_(window), runs_(runs) {
    connect(window.menus().aboutScan, &QAction::triggered, this, &ScanReportControl::open);
    connect(&runs, &RunControl::begun, this, &ScanReportControl::refresh);
    connect(&runs, &RunControl::modelFitted, this, &ScanReportControl::refresh);
}

void ScanReportControl::open() {
    if (runs_.run() == nullptr) {
        return;
    }
    if (dialog_ == nullptr) {
        dialog_ = new TextDialog(
            tr("About this scan"),
            tr("The scan that is open: where it comes from, and what was done to it"), &window_);
        dialog_->setObjectName(QStringLiteral("scanReport"));
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    refresh();
}

void ScanReportControl::refresh() {
    if (dialog_ != nullptr && dialog_->isVisible()) {
        dialog_->setText(QString::fromStdString(scanReport(runs_.run()->loaded())));
    }
}

}  // namespace asperity
