#pragma once

#include "app/window/Stage.h"
#include "app/window/device/EngageControl.h"
#include "app/window/device/PathPage.h"
#include "core/haptics/DevicePath.h"

#include <QPolygonF>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Heights and forces along the line of a path that the tip is on.
class LineRecord {
public:
    /// @param path of the base @param lines what it is made of; none: a file's, one way along it
    LineRecord(const DevicePath& path, const std::optional<LinesPlan>& lines);

    /// Takes a tick. @param time since the path began [s] @param height of the tip [m]
    void take(double time, const TickOutput& output, double height);
    /// Returns the line that a time belongs to, from 1.
    [[nodiscard]] int lineAt(double time) const;
    [[nodiscard]] double length() const { return length_; }  ///< [m]
    [[nodiscard]] const LinePlot::Ways& heights() const { return heights_; }
    [[nodiscard]] const LinePlot::Ways& forces() const { return forces_; }

private:
    struct Way {
        double begin = 0.0;  ///< [s]
        double end = 0.0;    ///< [s]
        int line = 0;        ///< from 1
        bool isTrace = true;
        double start = 0.0;  ///< distance where it begins [m]
        double reach = 0.0;  ///< by which it changes to the end [m]
        Vector3 direction = Vector3::UnitX();
    };

    std::vector<Way> ways_;
    double length_ = 0.0;   ///< of a line [m]
    int line_ = 0;          ///< that is recorded
    std::size_t next_ = 0;  ///< way that is not over yet
    double last_ = 0.0;     ///< time of the last point [s]
    LinePlot::Ways heights_;
    LinePlot::Ways forces_;
};

/// Paths that the device follows: planned ones, those of files, those of recordings. A path that is
/// chosen is shown, and starts when the user says so.
class PathControl : public Feature {
public:
    explicit PathControl(Stage& stage);

    [[nodiscard]] PathPage& page() { return *page_; }
    /// The device follows a path of the base from its start, at once. There is a run.
    void follow(const DevicePath& path);
    /// Shows the path of a CSV file, to be started; says in the window why it cannot be followed.
    void chooseFile(const QString& file);
    /// The device follows the base of a recorded run, at once. @param forceLog its table of ticks
    void replayRecording(const std::filesystem::path& forceLog);

private:
    enum class State { Idle, Engaging, Moving, Approaching };

    void addEntries();
    void connectPage();
    void choose(int index);
    void showChosen();
    /// Draws a path on the whole scan; empty: none.
    void showOnScan(const QPolygonF& path);
    void show();
    void start();
    void startLines(const PathRequest& request);
    void startApproach(const PathRequest& request);
    /// The tip has engaged where a path begins.
    void begin();
    /// Ends the path where it is; the tip is held as the window says.
    void end(const QString& words);
    void take(const TickSample& sample);
    void advance();
    void advanceLines();
    void advanceApproach();
    /// Returns whether the path that runs still has the tip.
    [[nodiscard]] bool hasTip() const;
    void forgetScan();
    [[nodiscard]] DevicePath pathOf(const PathRequest& request, const Vector3& base) const;
    [[nodiscard]] QString progress(double time) const;
    using ReadPath = std::function<DevicePath(const std::filesystem::path&)>;
    /// The path of a file; none where the window said why not.
    /// @param whyFar why the path may leave the scan by far
    [[nodiscard]] std::optional<DevicePath> readFile(const QString& file, const ReadPath& read,
                                                     const std::string& whyFar);

    DeviceControl& devices_;
    EngageControl& engaging_;
    PathPage* page_;                  ///< the window's
    std::optional<DevicePath> file_;  ///< the last one that was chosen
    State state_ = State::Idle;
    const HapticDevice* taken_ = nullptr;  ///< by the path that runs; only compared
    PathRequest request_;                  ///< of the path that runs
    double began_ = 0.0;                   ///< when it began to move along [s]
    double duration_ = 0.0;                ///< [s]
    int done_ = 0;                         ///< approaches
    std::optional<LineRecord> record_;
    QPolygonF shown_;       ///< on the whole scan [m]
    bool isFresh_ = false;  ///< the record has more than the page shows
};

}  // namespace asperity
