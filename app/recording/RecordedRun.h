#pragma once

#include "app/recording/RecordingRecovery.h"
#include "core/Vector.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/tables/CsvTable.h"
#include "core/surface/HeightMap.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// State of the folder of a run.
enum class RunState {
    Complete,
    Unfinished,  ///< a recording that was cut off: its tables may end in the middle of a line
    Recovered,   ///< one that was cut off, and was ended at its last whole tick
    Recording,   ///< a process is writing it
};

/// @return Complete for a folder without a manifest: `explore` leaves whole runs alone
/// @throw InputError where the manifest is damaged
[[nodiscard]] RunState stateOf(const std::filesystem::path& folder);
/// Returns a sentence on the state for people; empty for a complete run.
[[nodiscard]] std::string sentenceOf(RunState state);

/// The scan that a run was made on.
struct ScanRecord {
    std::string sha256;           ///< of its file; empty: a shape
    std::optional<Vector2> size;  ///< that it was read with [m]; none: the run does not say, as one
                                  ///< of an earlier version that was cut off
};

/// A run as its folder holds it; one that is not complete ends at its last whole tick.
struct RecordedRun {
    RunState state = RunState::Complete;
    ScanRecord scan;                  ///< that it was made on
    TickMemory memory;                ///< start of its first tick
    std::vector<TickSample> samples;  ///< its inputs
    CsvTable log;                     ///< its outputs; may be longer, where it is not complete
    std::vector<std::uint32_t> logChecks = {};  ///< of a log with fewer digits: RowChecks
};

/// Reads what a run says of its scan: its manifest or its summary, each once.
/// @throw InputError where there is no run, or one of the two is no text of ours
[[nodiscard]] ScanRecord scanRecord(const std::filesystem::path& folder);
/// Returns what its first tick starts from: a recording may begin in mid-run. @throw InputError
[[nodiscard]] TickMemory startMemory(const std::filesystem::path& folder);

/// @throw InputError
[[nodiscard]] RecordedRun readRun(const std::filesystem::path& folder);

/// The sample that a run was made on.
struct RecordedSample {
    std::string sha256;                  ///< of the scan's file; empty: a shape
    std::string channel;                 ///< of the scan
    std::optional<PixelRectangle> crop;  ///< part of it
    std::string name;                    ///< for people
};

/// @return nothing where the folder does not say
[[nodiscard]] std::optional<RecordedSample> sampleOf(const std::filesystem::path& folder);

/// The log of a run, up to the last whole line where it is not complete.
/// @param file that holds it: force_log.csv or recording.h5 @throw InputError
[[nodiscard]] CsvTable readRunLog(const std::filesystem::path& file);

}  // namespace asperity
