#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RecordedRun.h"

#include <filesystem>
#include <string>

namespace asperity {

struct Scene;

/// A run starts with its scene's settings and keeps its rate, but for whole periods that a live one
/// skips now and then: where the recorded input says otherwise, one of the two files was altered.
/// @throw Error naming the key
/// @param first        input of the run
/// @param shortestStep of all its inputs [s]
void requireSameSettings(const Scene& scene, const TickInput& first, double shortestStep);

/// Refuses a scene whose scan is not the one that a run was made on, or is read with another size
/// now: where a reader was wrong and has been corrected, no tick would be the same.
/// @throw InputError
void requireSameScan(const LoadedScene& loaded, const ScanRecord& recorded);

/// Returns the correction of a reader that may be why a run does not replay, a clause, where the
/// run does not say with which size its scan was read; empty: none is known.
/// @throw InputError where the scan cannot be read any more
[[nodiscard]] std::string correctionOfScan(const LoadedScene& loaded, const ScanRecord& recorded);

/// Returns why a run does not replay: the correction of a reader, where that may be why and the run
/// does not say with which size its scan was read; and the difference.
/// @param difference of requireSameLog() or differenceOnReplay()
/// @throw InputError where the scan cannot be read any more
[[nodiscard]] std::string failureOfReplay(const std::string& difference, const LoadedScene& loaded,
                                          const ScanRecord& recorded);

/// Runs the recorded inputs through the tick again: `sink` gets each sample with its output.
/// @throw Error where the scene's settings are not those that the run began with, naming the key
void replayTicks(const Scene& scene, const RecordedRun& run, const TickSink& sink);

/// The same, and writes its logs.
/// @param out an empty folder
/// @param sink gets each sample, too
/// @return the force log
/// @throw Error as replayTicks()
[[nodiscard]] CsvTable replay(const Scene& scene, const RecordedRun& run,
                              const std::filesystem::path& out, const TickSink& sink = {});

/// Compares two force logs cell by cell, as text: the numbers are written to the last bit. Of a log
/// with fewer digits, those and the checks of all. Columns that came after the recording was made
/// are not in it.
/// @throw Error naming the first tick that differs, and saying so where flags alone differ;
/// InputError naming the recorded log where it has a column that no log has
void requireSameLog(const RecordedRun& run, const CsvTable& replayed);

/// Runs the ticks again and compares the logs.
/// @param scratch a temporary folder for the log, which must not exist
/// @return the first tick that differs from the recorded log, a clause; empty: none
/// @throw Error as replayTicks(); Canceled
[[nodiscard]] std::string differenceOnReplay(const Scene& scene, const RecordedRun& run,
                                             const std::filesystem::path& scratch,
                                             const TickSink& sink, Progress* progress);

}  // namespace asperity
