#pragma once

#include "app/runs/OutputFolder.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/recording/TickLog.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// Names of the files that a recorded run consists of.
namespace run_files {
inline constexpr const char* kScene = "scene.toml";
inline constexpr const char* kInput = "tick_input.csv";
inline constexpr const char* kTables = "recording.h5";     ///< all tables of a compact run
inline constexpr const char* kMemory = "tick_memory.csv";  ///< absent: the run began afresh
inline constexpr const char* kLog = "force_log.csv";
inline constexpr const char* kEnergy = "energy_log.csv";    ///< of a force-feedback device
inline constexpr const char* kManifest = "recording.json";  ///< of what Record wrote
inline constexpr const char* kSummary = "summary.json";
inline constexpr const char* kDeformation = "deformation.png";
inline constexpr const char* kDeformationFields = "deformation.exr";
inline constexpr const char* kOverview = "overview.png";
inline constexpr const char* kForces = "forces.png";
}  // namespace run_files

/// All of them: none of a new run stands beside one of an earlier run.
[[nodiscard]] const std::vector<std::string>& runFileNames();
/// What `asperity explore` leaves: it replaces another such run, and no recording unasked.
[[nodiscard]] FolderContent exploredRun();
/// What `asperity convert` makes of a run: it replaces no other one unasked, not even its own.
[[nodiscard]] FolderContent convertedRun();
/// What `asperity replay` leaves: it replaces other logs of its own, and no run unasked.
[[nodiscard]] FolderContent replayedLogs();

/// Writes the two tables of a run tick by tick; they grow in their place.
class RunRecorder {
public:
    /// @param field as ForceLogWriter takes it @throw Error when a table is there or cannot be made
    explicit RunRecorder(const std::filesystem::path& folder,
                         std::shared_ptr<const MaterialField> field = nullptr);

    void take(const TickSample& sample);
    /// Hands all ticks so far to the system. @throw Error
    void flush();
    /// Waits until the disk holds what was flushed. @throw Error
    void sync() const;
    /// Writes what is left. @throw Error
    void close();

private:
    ForceLogWriter log_;
    TickInputWriter input_;
};

/// Whether the path leads to anything, a link to nothing included.
[[nodiscard]] bool isThere(const std::filesystem::path& path);

/// Whether a file is the scene of a run: the ticks of the run lie beside it.
[[nodiscard]] bool isSceneOfRun(const std::filesystem::path& file);

/// Refuses to write over what is there. @param force it may go @throw Error
void requireFree(const std::filesystem::path& file, bool force);
/// Refuses to write into an input, the folder of a run or a file, which nothing may replace.
/// @throw Error
void requireOutside(const std::filesystem::path& input, const std::filesystem::path& file);

/// Writes a small text file whole or not at all. @throw Error
void writeTextFile(const std::filesystem::path& path, const std::string& text);

}  // namespace asperity
