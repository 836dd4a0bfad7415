#pragma once

#include "app/program/DataFolder.h"
#include "app/program/EndSignals.h"
#include "app/window/Stage.h"
#include "app/window/live/LivePanels.h"
#include "app/window/session/WindowMemory.h"
#include "ui/shell/MainWindow.h"

#include <QApplication>
#include <QObject>
#include <QSocketNotifier>

#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// The program with its window, from the display to the features behind it.
class LiveWindow {
public:
    /// @throw Error when there is no display
    LiveWindow();

    [[nodiscard]] Stage& stage() { return stage_; }
    [[nodiscard]] LivePanels& panels() { return panels_; }
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
    LivePanels panels_;
    std::optional<WindowMemory> memory_;
    Stage stage_;
};

/// Ends the event loop in good order on SIGINT, SIGTERM and SIGHUP, so that recordings are kept and
/// the operator feels nothing any more. One of them at a time.
class QuitOnSignal : public QObject {
public:
    QuitOnSignal();
    ~QuitOnSignal() override;
    QuitOnSignal(const QuitOnSignal&) = delete;
    QuitOnSignal& operator=(const QuitOnSignal&) = delete;

private:
    QSocketNotifier arrival_;
    std::optional<EndSignals> signals_;
};

/// Measures the time from the start of the program's process until its window shows something. Once
/// a scan is drawn it ends the program.
class StartTimes : public QObject {
public:
    explicit StartTimes(LiveWindow& live);

    /// As one JSON object, once the program has ended; times in seconds.
    [[nodiscard]] std::string json() const;

private:
    void shown();

    LiveWindow& live_;
    bool isDrawn_ = false;  ///< a frame with a scan, perhaps not shown yet
    double window_ = 0.0;   ///< until the window's first frame [s]
    double picture_ = 0.0;  ///< until the first frame with a scan [s]
};

}  // namespace asperity
