#pragma once

#include "app/session/LongWork.h"
#include "app/session/RecordingControl.h"
#include "app/session/ViewControl.h"

#include <QString>

#include <filesystem>

namespace asperity {

/// One click puts the last recording, or the last 10 s where there is none, with its scan and a
/// picture of the window into one file beside it.
class BundleControl : public QObject {
    Q_OBJECT

public:
    BundleControl(MainWindow& window, RunControl& runs, RecordingControl& recordings,
                  ViewControl& views);

Q_SIGNALS:
    void bundled(QString file);

private:
    void bundle();
    void bundle(const QString& folder);

    MainWindow& window_;
    RunControl& runs_;
    RecordingControl& recordings_;
    ViewControl& views_;
    QString last_;            ///< folder of the last recording of this run; empty: there is none
    bool isAwaited_ = false;  ///< what is to be bundled is being written
    LongWork<std::filesystem::path> work_;
};

}  // namespace asperity
