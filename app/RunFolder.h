#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/io/TickLog.h"

#include <filesystem>
#include <string>

namespace asperity {

/// Names of the files that a recorded run consists of.
namespace run_files {
inline constexpr const char* kScene = "scene.toml";
inline constexpr const char* kInput = "tick_input.csv";
inline constexpr const char* kMemory = "tick_memory.csv";  ///< absent: the run began afresh
inline constexpr const char* kLog = "force_log.csv";
inline constexpr const char* kEnergy = "energy_log.csv";  ///< of a hand with motors
inline constexpr const char* kSummary = "summary.json";
inline constexpr const char* kDeformation = "deformation.png";
inline constexpr const char* kDeformationFields = "deformation.exr";
inline constexpr const char* kOverview = "overview.png";
inline constexpr const char* kForces = "forces.png";
}  // namespace run_files

/// Writes the two tables of a run tick by tick; each appears whole or not at all.
class RunRecorder {
public:
    /// @throw Error when the folder cannot be made or written
    explicit RunRecorder(const std::filesystem::path& folder);

    void take(const TickSample& sample);
    /// Puts the tables in place. @throw Error
    void close();

private:
    ForceLogWriter log_;
    TickInputWriter input_;
};

/// Makes a folder for output where there is none. @throw Error
void makeOutputFolder(const std::filesystem::path& folder);

/// Removes from a folder what an earlier run left there and a new one does not write over at once:
/// its pictures and what it started from. No log stands beside what belongs to another one, even
/// where drawing fails or is cancelled. @throw Error
void removeEarlierResults(const std::filesystem::path& folder);

/// Writes a small text file whole or not at all. @throw Error
void writeTextFile(const std::filesystem::path& path, const std::string& text);

}  // namespace asperity
