#pragma once

#include "app/LoadedScene.h"
#include "app/RunFolder.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/RunEvents.h"

#include <filesystem>

namespace asperity {

/// A stretch of a live run written to a folder that `asperity replay` takes.
class Recording {
public:
    /// @param settings the knobs as the recording begins
    /// @param memory   what its first tick starts from
    /// @throw Error when the folder cannot be made or written
    Recording(std::filesystem::path folder, const LoadedScene& loaded, const Settings& settings,
              const TickMemory& memory);

    void take(const TickSample& sample);
    /// Puts all files in place. @throw Error
    void finish();

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }
    [[nodiscard]] long ticks() const noexcept { return events_.events().ticks; }

private:
    std::filesystem::path folder_;
    const LoadedScene& loaded_;
    RunRecorder recorder_;
    RunEventRecorder events_;
};

}  // namespace asperity
