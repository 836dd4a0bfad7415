#pragma once

#include "app/runs/ClaimedFolder.h"

#include <filesystem>

namespace asperity {

/// A recording is written into its folder from its first tick on, so the folder must not hold a run
/// yet, but for one that may be replaced. Changes nothing.
/// @throw Error where it does, or a recording goes on there
void requireFreeForRun(const std::filesystem::path& folder, bool replace);

/// The folder of a run that begins. What an earlier run left is set aside, in the folder
/// replaced_run within it; without keep() all is as before: what the new run wrote goes, what was
/// set aside comes back. Killed in these milliseconds, a process leaves it there.
class BeginningRun {
public:
    /// Makes the folder where there is none.
    /// @param replace the files of an earlier run may go @throw Error as requireFreeForRun(), or
    /// when the folder cannot be written
    BeginningRun(std::filesystem::path folder, bool replace);
    ~BeginningRun();
    BeginningRun(const BeginningRun&) = delete;
    BeginningRun& operator=(const BeginningRun&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_.path(); }
    /// The new run is there: what was set aside goes.
    void keep() noexcept;

private:
    void setAside();
    void putBack() noexcept;

    ClaimedFolder folder_;
    std::filesystem::path aside_;  ///< empty: nothing was there
    bool kept_ = false;
};

}  // namespace asperity
