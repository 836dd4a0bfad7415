#pragma once

#include "core/LatestWriter.h"

#include <QSettings>
#include <QTimer>
#include <QVariantMap>

#include <memory>

namespace asperity {

class LivePanels;
class MainWindow;

/// Keeps position and size of the window, which panels are folded, hidden or on top, how splitters
/// divide the space, how the views look, and the theme, from one session to the next, whatever
/// ends the program. Without readable settings it opens in its initial state.
class WindowMemory {
public:
    /// Positions the window as `settings` have it, on the screens that there are now.
    WindowMemory(MainWindow& window, LivePanels& live, std::unique_ptr<QSettings> settings);
    /// An enlarged panel goes back, and all is written as it is then.
    ~WindowMemory();
    WindowMemory(const WindowMemory&) = delete;
    WindowMemory& operator=(const WindowMemory&) = delete;

private:
    [[nodiscard]] QVariantMap present() const;
    /// Passes what has changed to the writer.
    void keep();

    MainWindow& window_;
    LivePanels& live_;
    QVariantMap kept_;                  ///< that the writer has
    LatestWriter<QVariantMap> writer_;  ///< the window waits for no disk
    QTimer due_;
};

/// The user's own settings of the program.
[[nodiscard]] std::unique_ptr<QSettings> userSettings();

}  // namespace asperity
