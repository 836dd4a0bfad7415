#pragma once

#include "app/program/LoadedScene.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/haptics/EnergyWatch.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/tables/CsvWriter.h"

#include <filesystem>
#include <optional>

namespace asperity {

/// Writes energy_log.csv: the trace of the passivity observer, one row a tick that a device with
/// motors drove the tip. Without such a tick there is no file.
class EnergyLog {
public:
    /// @param timeStep from tick to tick [s]
    /// @param delay    of the device [s]
    EnergyLog(std::filesystem::path path, double timeStep, double delay);

    /// @throw Error when the file is there or cannot be made
    void take(const TickSample& sample);
    /// Hands all rows so far to the system. @throw Error
    void flush();
    /// Waits until the disk holds what was flushed. @throw Error
    void sync() const;

private:
    std::filesystem::path path_;
    EnergyWatch watch_;
    std::optional<CsvWriter> csv_;  ///< of a GrowingFile; none before the first row
};

/// Destination of a recording.
struct RecordingTarget {
    std::filesystem::path folder;
    bool replace = false;  ///< deletes an earlier run in it, once the recording has begun
    RunFormat format = RunFormat::Csv;  ///< from its end on: until then it grows as text
};

/// A stretch of a live run written to a folder that `asperity replay` reads: memory, scene and
/// manifest first, then the tables, which grow in their place. Whatever ends it, what was flushed
/// replays; without finish() its manifest says that it is not complete.
class Recording {
public:
    /// @param memory at the start of its first tick
    /// @param delay  of the device [s]
    /// @throw Error when the folder cannot be made or written, or holds a run
    Recording(const RecordingTarget& target, const LoadedScene& loaded, const TickMemory& memory,
              double delay);

    /// Every tick; from the first one that is missing on, none is taken. @throw Error
    void take(const TickSample& sample);
    /// Ticks were lost: what was taken ends before them.
    [[nodiscard]] bool broken() const noexcept { return broken_; }
    /// Passes all ticks so far to the system: a killed process loses none of them. @throw Error
    void flush();
    /// Waits until the disk holds what was flushed: a power cut loses none of it. @throw Error
    void sync();
    /// Writes what is left, and that it is complete. @throw Error
    void finish();

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return begin_.folder(); }
    [[nodiscard]] long ticks() const noexcept { return events_.events().ticks; }

private:
    void writeScene(const Settings& start);

    PendingRunFolder begin_;
    const LoadedScene& loaded_;
    RunFormat format_;
    RunRecorder recorder_;
    RunEventRecorder events_;
    EnergyLog energy_;
    Settings start_;         ///< the knobs of the first tick, as in the scene's file
    double lastTime_ = 0.0;  ///< [s]
    bool broken_ = false;
    bool startSynced_ = false;  ///< the disk holds what the first tick starts from
};

}  // namespace asperity
