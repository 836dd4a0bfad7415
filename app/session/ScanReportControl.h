#pragma once

#include "app/session/RunControl.h"

#include <QPointer>

namespace asperity {

class TextDialog;

/// File > About this scan: what is known of the scan that is open, to be read back.
class ScanReportControl : public QObject {
    Q_OBJECT

public:
    ScanReportControl(MainWindow& window, const RunControl& runs);

private:
    void open();
    /// Another scene has another text.
    void refresh();

    MainWindow& window_;
    const RunControl& runs_;
    QPointer<TextDialog> dialog_;
};

}  // namespace asperity
