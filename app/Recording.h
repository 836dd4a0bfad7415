#pragma once

#include "app/EnergyLog.h"
#include "app/LoadedScene.h"
#include "app/RunFolder.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/RunEvents.h"

#include <filesystem>

namespace asperity {

/// A stretch of a live run written to a folder that `asperity replay` takes.
class Recording {
public:
    /// @param memory what its first tick starts from
    /// @param delay  of the hand's device [s]
    /// @throw Error when the folder cannot be made or written
    Recording(std::filesystem::path folder, const LoadedScene& loaded, const TickMemory& memory,
              double delay);

    /// Every tick; from the first one that is missing on, none is taken.
    void take(const TickSample& sample);
    /// Ticks were lost: what was taken ends before them.
    [[nodiscard]] bool broken() const noexcept { return broken_; }
    /// Puts all files in place. @throw Error
    void finish();

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }
    [[nodiscard]] long ticks() const noexcept { return events_.events().ticks; }

private:
    std::filesystem::path folder_;
    const LoadedScene& loaded_;
    RunRecorder recorder_;
    RunEventRecorder events_;
    EnergyLog energy_;
    Settings start_;         ///< the knobs of the first tick
    double lastTime_ = 0.0;  ///< [s]
    bool broken_ = false;
};

}  // namespace asperity
