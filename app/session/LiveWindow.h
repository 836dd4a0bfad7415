#pragma once

#include "app/program/RuntimeFolder.h"
#include "app/session/Session.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMemory.h"

#include <QApplication>

#include <memory>
#include <optional>

namespace asperity {

/// The program with its window, from the display to the session behind it.
class LiveWindow {
public:
    /// @throw Error when there is no display
    LiveWindow();

    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] MainWindow& window() { return window_; }

    /// The window opens as `settings` remember it, and leaves there how it is in the end.
    void remember(std::unique_ptr<QSettings> settings);

    /// Shows the window and stays until it is closed, or the program is asked to end by SIGINT,
    /// SIGTERM or SIGHUP. @return the exit status
    int exec();

private:
    struct Display {
        Display();
    };

    /// An exception must not cross Qt's event loop: it ends the program in good order.
    class Application : public QApplication {
    public:
        Application(int& argumentCount, char** arguments);
        bool notify(QObject* receiver, QEvent* event) override;
    };

    Display display_;
    RuntimeFolder runtime_;
    int argumentCount_ = 1;
    char* arguments_[2];
    Application application_;
    MainWindow window_;
    std::optional<WindowMemory> memory_;
    Session session_;
};

}  // namespace asperity
