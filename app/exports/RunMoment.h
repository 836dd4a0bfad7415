#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RunPlayback.h"
#include "core/EnumTable.h"
#include "core/SiFormat.h"
#include "core/haptics/VirtualRun.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace asperity {

/// Named moments of a run.
enum class NamedMoment : std::uint8_t {
    Deepest,
    SnapIn,   ///< first tick of the first contact
    PullOff,  ///< last moment of the last contact, see RunEvents::lastHold
    Start,
    End,
};

template <>
inline constexpr auto kEnumTable<NamedMoment> =
    std::to_array<EnumRow<NamedMoment>>({{NamedMoment::Deepest, "deepest", "Maximum indentation"},
                                         {NamedMoment::SnapIn, "snap-in", "Snap-in"},
                                         {NamedMoment::PullOff, "pull-off", "Just before pull-off"},
                                         {NamedMoment::Start, "start", "Start"},
                                         {NamedMoment::End, "end", "End"}});

/// A word, or a time of the run [s].
using RunMoment = std::variant<NamedMoment, double>;

/// @throw Error where it is neither
[[nodiscard]] RunMoment runMoment(const std::string& text);

/// Returns the tick of a named moment, but for start and end; none: the run has no such moment.
[[nodiscard]] std::optional<TickSample> sampleOf(const RunEvents& events, NamedMoment moment);

/// The tick of a moment. Events are found by running all of it.
/// @throw Error where the run has no such moment, with its range; Canceled
[[nodiscard]] std::size_t tickOf(RunPlayback& run, const RunMoment& moment,
                                 Progress* progress = nullptr);

/// Writes time, normal force, distance and state of moments in one line. Moments that are taken
/// first decide on the units, so that digits stay where they are from one line to the next.
class MomentCaption {
public:
    void take(const TickSample& sample);
    /// "t = 3.214 s, normal force 12.30 nN, indentation 1.20 nm, in contact"; the force is the
    /// estimate, along the normal of the surface.
    [[nodiscard]] std::string of(const TickSample& sample) const;

private:
    double force_ = 0.0;     ///< largest magnitude so far [N]
    double distance_ = 0.0;  ///< [m]
};

/// Returns the stem of names of files: a file's without its extension, or the folder's of a run.
[[nodiscard]] std::string exportName(const std::filesystem::path& input);

/// Returns whether it is the folder of a run, or a bundle of one.
[[nodiscard]] bool holdsRun(const std::filesystem::path& input);

/// Input of an export: a scene, and where there is one, its run.
class ExportInput {
public:
    /// @param input scene.toml, a height map, the folder of a run or a bundle
    /// @throw InputError where it cannot be read, or the scan has changed since the run; Canceled
    explicit ExportInput(const std::filesystem::path& input, Progress* progress = nullptr);

    [[nodiscard]] const LoadedScene& loaded() const { return *loaded_; }
    [[nodiscard]] const Scene& scene() const { return loaded_->scene; }
    /// Null: there is none.
    [[nodiscard]] RunPlayback* run() { return run_ ? &*run_ : nullptr; }
    /// Returns a note on a run that is not complete; empty: it is.
    [[nodiscard]] const std::string& note() const { return note_; }
    /// The surface at rest with the tip where the window starts with it.
    [[nodiscard]] TickSample restingSample() const;

private:
    std::string note_;
    std::unique_ptr<const LoadedScene> loaded_;
    std::optional<RunPlayback> run_;
};

}  // namespace asperity
