#pragma once

#include "app/session/RunControl.h"
#include "core/haptics/cycle/CycleDetector.h"
#include "ui/measure/Touch.h"
#include "ui/measure/TouchMarks.h"

#include <filesystem>
#include <vector>

namespace asperity {

class TouchesPage;

/// Collects all touches of the session, whatever scene they are of, for their table and their marks
/// on the whole scan.
class TouchControl : public QObject {
public:
    TouchControl(MainWindow& window, RunControl& runs);

    [[nodiscard]] TouchesPage& page() { return *page_; }
    /// Every tick, in order; allocates nothing but at the first contact of a touch.
    void take(const TickSample& sample);
    /// Once a frame: shows new touches at once, and a few times a second how the last one goes on.
    void show();
    /// Writes all touches; says in the window when that fails.
    void writeTo(const std::filesystem::path& file);

private:
    void begin();
    void end();
    void clear();
    void askForFile();
    /// @param more there are new touches
    void update(bool more);
    void markAll();

    MainWindow& window_;
    RunControl& runs_;
    TouchesPage* page_;  ///< the window's
    TouchMarks marks_;
    CycleDetector detector_;
    std::vector<Touch> fresh_;  ///< that the table does not show yet, or not as they are now
    std::int64_t number_ = -1;  ///< of the cycle of the last touch of this run; -1: none yet
    bool continues_ = false;    ///< the first of `fresh_` is the last row of the table, gone on
    int framesSince_ = 0;       ///< the last update
    QString material_;
    QString scan_;
};

}  // namespace asperity
