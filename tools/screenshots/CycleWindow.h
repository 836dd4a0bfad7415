#pragma once

#include "app/commands/VirtualDisplay.h"
#include "app/session/LiveWindow.h"

#include <QTimer>

#include <functional>
#include <string>

namespace asperity {

/// A live window in which the tip approaches to the setpoint of the scene and retracts: far,
/// snapped_in, indenting, retracting (shortly before pull-off) and off.
class CycleWindow {
public:
    /// @param arguments of a tool that makes pictures: its name, scene, width, height, prefix
    explicit CycleWindow(char** arguments);

    [[nodiscard]] MainWindow& window() { return live_.window(); }
    [[nodiscard]] Session& session() { return live_.session(); }
    [[nodiscard]] const TickOutput& newest();
    /// Saves what the window shows.
    void save(const std::string& name);
    void pause();
    void resume();
    /// Once through the cycle. @param seen is called with the name of each moment; of retracting
    /// more than once, its last call counts @throw Error: a moment was not seen in time
    int run(int milliseconds, std::function<void(const std::string&)> seen);

private:
    void look();

    VirtualDisplay display_;
    LiveWindow live_;
    std::string prefix_;
    std::function<void(const std::string&)> seen_;
    std::size_t next_ = 0;  ///< moment
    QTimer timer_;
};

}  // namespace asperity
