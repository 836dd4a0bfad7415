#pragma once

#include <QObject>

#include <string>

namespace asperity {

class LiveWindow;

/// How long the program takes, from the start of its process, until its window shows something.
/// Once a scan is drawn it ends the program.
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
