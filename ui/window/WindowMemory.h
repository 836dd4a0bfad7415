#pragma once

#include <QSettings>

#include <memory>

namespace asperity {

class MainWindow;

/// Keeps place and size of the window, which panels are folded, hidden or on top, how splitters
/// share out the room, how the views look, and the theme, from one session to the next. Where the
/// settings cannot be read or written the window opens as at first.
class WindowMemory {
public:
    /// Places the window as `settings` have it, on the screens that there are now.
    WindowMemory(MainWindow& window, std::unique_ptr<QSettings> settings);
    /// Writes how the window is then.
    ~WindowMemory();
    WindowMemory(const WindowMemory&) = delete;
    WindowMemory& operator=(const WindowMemory&) = delete;

private:
    MainWindow& window_;
    std::unique_ptr<QSettings> settings_;
};

/// The user's own settings of the program.
[[nodiscard]] std::unique_ptr<QSettings> userSettings();

}  // namespace asperity
