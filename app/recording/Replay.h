#pragma once

#include "app/recording/RecordedRun.h"
#include "core/scene/Scene.h"

#include <filesystem>

namespace asperity {

/// A run starts with its scene's settings and keeps its rate, but for whole periods that a live one
/// skips now and then: where the recorded input says otherwise, one of the two files was altered.
/// @throw Error naming the key
/// @param first        input of the run
/// @param shortestStep of all its inputs [s]
void requireSameSettings(const Scene& scene, const TickInput& first, double shortestStep);

/// Runs the recorded inputs through the tick again: `sink` gets each sample with its output.
/// @throw Error where the scene's settings are not those that the run began with, naming the key
void replayTicks(const Scene& scene, const RecordedRun& run, const TickSink& sink);

/// The same, and writes its logs.
/// @param out an empty folder
/// @return the force log
/// @throw Error as replayTicks()
[[nodiscard]] CsvTable replay(const Scene& scene, const RecordedRun& run,
                              const std::filesystem::path& out);

/// Compares two force logs cell by cell, as text: the numbers are written to the last bit. Columns
/// that came after the recording was made are not in it.
/// @throw Error naming the first tick that differs
void requireSameLog(const RecordedRun& run, const CsvTable& replayed);

}  // namespace asperity
