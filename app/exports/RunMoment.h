#pragma once

#include "app/recording/RunPlayback.h"
#include "core/EnumTable.h"
#include "core/haptics/RunEvents.h"

#include <optional>
#include <string>
#include <variant>

namespace asperity {

/// Moments of a run that have a word.
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

/// Where a named moment is, but for start and end, by the events of a run; none: it has none.
[[nodiscard]] std::optional<TickSample> sampleOf(const RunEvents& events, NamedMoment moment);

/// The tick of a moment. Events are found by running all of it.
/// @throw Error where the run has no such moment, with its range; Canceled
[[nodiscard]] std::size_t tickOf(RunPlayback& run, const RunMoment& moment,
                                 Progress* progress = nullptr);

}  // namespace asperity
