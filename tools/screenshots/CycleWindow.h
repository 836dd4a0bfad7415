#pragma once

#include "app/commands/VirtualDisplay.h"
#include "app/window/Stage.h"
#include "app/window/lab/LiveWindow.h"

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
    [[nodiscard]] LivePanels& panels() { return live_.panels(); }
    [[nodiscard]] Stage& stage() { return live_.stage(); }
    [[nodiscard]] const TickOutput& newest();
    /// Saves what the window shows.
    void save(const std::string& name);
    void pause();
    void resume();
    /// Once through the cycle. Where the machine is so busy that a moment passed unseen, the cycle
    /// begins again at half the speed. @param seen is called with the name of each moment, more
    /// than once of some: the last call counts @throw Error: the loop stands still, or a moment
    /// does not come
    int run(std::function<void(const std::string&)> seen);

private:
    void begin();
    void look();
    /// Whether the approach is over: a moment that has not come will not come.
    [[nodiscard]] bool isBack();
    [[nodiscard]] bool isStanding();

    VirtualDisplay display_;
    LiveWindow live_;
    std::string scene_;
    std::string prefix_;
    double duration_;          ///< of the approach and the way back [s]
    double newestTime_ = 0.0;  ///< of the run, when it was looked at [s]
    int looksSince_ = 0;       ///< with no newer tick
    std::function<void(const std::string&)> seen_;
    std::size_t next_ = 0;  ///< moment
    QTimer timer_;
};

}  // namespace asperity
