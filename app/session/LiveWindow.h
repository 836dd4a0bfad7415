#pragma once

#include "app/session/Session.h"
#include "ui/window/MainWindow.h"

#include <QApplication>

namespace asperity {

/// The program with its window, from the display to the session behind it.
class LiveWindow {
public:
    /// @throw Error when there is no display
    LiveWindow();

    [[nodiscard]] Session& session() { return session_; }
    [[nodiscard]] MainWindow& window() { return window_; }

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
        using QApplication::QApplication;
        bool notify(QObject* receiver, QEvent* event) override;
    };

    Display display_;
    int argumentCount_ = 1;
    char* arguments_[2];
    Application application_;
    MainWindow window_;
    Session session_;
};

}  // namespace asperity
