#pragma once

#include "core/LatestWriter.h"

#include <QSettings>
#include <QTimer>
#include <QVariantMap>

#include <memory>

namespace asperity {

class MainWindow;

/// Keeps place and size of the window, which panels are folded, hidden or on top, how splitters
/// share out the room, how the views look, and the theme, from one session to the next, whatever
/// ends the program. Where the settings cannot be read or written the window opens as at first.
class WindowMemory {
public:
    /// Places the window as `settings` have it, on the screens that there are now.
    WindowMemory(MainWindow& window, std::unique_ptr<QSettings> settings);
    /// An enlarged panel goes back, and all is written as it is then.
    ~WindowMemory();
    WindowMemory(const WindowMemory&) = delete;
    WindowMemory& operator=(const WindowMemory&) = delete;

private:
    [[nodiscard]] QVariantMap present() const;
    /// Hands what has changed to the writer.
    void keep();

    MainWindow& window_;
    QVariantMap kept_;                  ///< that the writer has
    LatestWriter<QVariantMap> writer_;  ///< the window waits for no disk
    QTimer due_;
};

/// The user's own settings of the program.
[[nodiscard]] std::unique_ptr<QSettings> userSettings();

}  // namespace asperity
