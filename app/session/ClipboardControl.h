#pragma once

#include "app/session/ViewControl.h"

namespace asperity {

/// Puts on the clipboard what the window shows: the large view, the window, a plot, the numbers.
class ClipboardControl : public QObject {
    Q_OBJECT

public:
    /// @param window, runs, views outlive this
    ClipboardControl(MainWindow& window, RunControl& runs, ViewControl& views);

private:
    void copyView();
    void copyWindow();
    void copyPlot();
    void copyNumbers();

    MainWindow& window_;
    RunControl& runs_;
    ViewControl& views_;
};

}  // namespace asperity
