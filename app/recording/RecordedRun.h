#pragma once

#include "app/recording/RecordingManifest.h"
#include "core/Vector.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/tables/CsvTable.h"
#include "core/surface/PixelRectangle.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// How far the folder of a run has come.
enum class RunState {
    Complete,
    Unfinished,  ///< a recording that was cut off: its tables may end in the middle of a line
    Recovered,   ///< one that was cut off, and was ended at its last whole tick
    Recording,   ///< a process is writing it
};

/// @return Complete for a folder without a manifest: `explore` leaves whole runs alone
/// @throw InputError where the manifest is damaged
[[nodiscard]] RunState stateOf(const std::filesystem::path& folder);
/// For people; empty for a complete run.
[[nodiscard]] std::string sentenceOf(RunState state);

/// A run as its folder holds it; one that is not complete goes up to its last whole tick.
struct RecordedRun {
    RunState state = RunState::Complete;
    std::string sha256;               ///< of the scan that it was made on
    TickMemory memory;                ///< what its first tick starts from
    std::vector<TickSample> samples;  ///< its inputs
    CsvTable log;                     ///< what it did; may be longer, where it is not complete
    std::vector<std::uint32_t> logChecks = {};  ///< of a log with fewer digits: RowChecks
};

/// The hash of the scan's file that a run was made on; empty: a shape. @throw InputError where
/// there is no run
[[nodiscard]] std::string recordedHash(const std::filesystem::path& folder);
/// The size that the scan was read with when the run was made [m]; none: the run does not say, as
/// one of an earlier version that was cut off.
/// @throw InputError where its summary or its manifest is no text of ours
[[nodiscard]] std::optional<Vector2> recordedSize(const std::filesystem::path& folder);
/// What its first tick starts from: a recording may begin in the middle of a run. @throw InputError
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
/// @param file that it stands in: force_log.csv or recording.h5 @throw InputError
[[nodiscard]] CsvTable readRunLog(const std::filesystem::path& file);

}  // namespace asperity
