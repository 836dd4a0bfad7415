#pragma once

#include "app/runs/OutputFolder.h"
#include "core/EnumTable.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/recording/TickLog.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

struct LoadedScene;
struct RunEvents;

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

/// All of them: none of a new run is beside one of an earlier run.
[[nodiscard]] const std::vector<std::string>& runFileNames();
/// Files of `asperity explore`: it replaces another such run, and no recording unasked.
[[nodiscard]] FolderContent exploredRun();
/// Files of a run made by `asperity convert`: it replaces no other one unasked, not even its own.
[[nodiscard]] FolderContent convertedRun();
/// Files of `asperity replay`: it replaces other logs of its own, and no run unasked.
[[nodiscard]] FolderContent replayedLogs();

/// Writes the two tables of a run tick by tick; they grow in their place.
class RunRecorder {
public:
    /// @param field as in ForceLogWriter @throw Error when a table is there or cannot be made
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

/// Returns whether the path leads to anything, a link to nothing included.
[[nodiscard]] bool isThere(const std::filesystem::path& path);

/// Returns whether a file is the scene of a run: the ticks of the run lie beside it.
[[nodiscard]] bool isSceneOfRun(const std::filesystem::path& file);

/// Refuses to write over what is there. @param force it may be replaced @throw Error
void requireFree(const std::filesystem::path& file, bool force);
/// Refuses to write into an input, the folder of a run or a file, which nothing may replace.
/// @throw Error
void requireOutside(const std::filesystem::path& input, const std::filesystem::path& file);

/// Writes a small text file whole or not at all. @throw Error
void writeTextFile(const std::filesystem::path& path, const std::string& text);

/// summary.json of a run: versions, scene, input and its hash, statistics and events. Depends on
/// the run alone, so that the same run gives the same bytes.
[[nodiscard]] std::string runSummary(const LoadedScene& loaded, const RunEvents& events);

/// Decision on a term of a run's model when the run was made.
struct RecordedTerm {
    std::string name;
    bool on = false;
    bool overruled = false;  ///< by the scene
    double effect = 0.0;     ///< of leaving it out, as a share of what it changes most
    std::string why;
};

/// The program that made a run.
struct RecordedProgram {
    std::string version;
    std::string compiler;
};

/// Content of summary.json that the run itself does not hold, as its scene has all decisions
/// settled: the reasons.
struct RecordedSummary {
    std::vector<std::string> notes;
    std::vector<RecordedTerm> terms;
};

/// Record of how a run was made, from its folder.
struct RunRecord {
    std::optional<RecordedProgram> program;  ///< none: the folder does not say
    std::optional<RecordedSummary> summary;  ///< none: the run was cut off
};

/// Reads summary.json and, where that does not say by what the run was made, recording.json. What
/// an earlier version did not write is empty.
/// @throw InputError where one of them is damaged
[[nodiscard]] RunRecord readRecord(const std::filesystem::path& folder);

/// Format of the tables of a run.
enum class RunFormat : std::uint8_t {
    Csv,   ///< as text, a file each
    Hdf5,  ///< in one HDF5 file of about a tenth of the size
};

template <>
inline constexpr auto kEnumTable<RunFormat> = std::to_array<EnumRow<RunFormat>>(
    {{RunFormat::Csv, "csv", "Text (CSV)"}, {RunFormat::Hdf5, "h5", "Compact (HDF5)"}});

}  // namespace asperity
