#pragma once

#include "app/recording/Bundle.h"
#include "core/Progress.h"
#include "core/io/heightmap/ImageScale.h"

#include <filesystem>

namespace asperity {

/// The folder of a run that a user names by it, or by a bundle. A bundle is unpacked among the
/// user's own data, where it stays: a session may name its scan.
/// @throw InputError where it is neither; Error; Canceled
[[nodiscard]] std::filesystem::path unpackedRun(const std::filesystem::path& input,
                                                Progress* progress = nullptr);

/// Runs what reads files in the folder of unpackedRun(). A refusal of one that is in a bundle names
/// the bundle and that part of it; that a scale is missing is passed on as it is, for the window
/// asks for it. @return what `work` returns @throw as `work`
template <class Work>
auto readStaying(const std::filesystem::path& input, const std::filesystem::path& folder,
                 const Work& work) {
    try {
        return work();
    } catch (const MissingScale&) {
        throw;
    } catch (const FileError& refusal) {
        if (folder == input) {
            throw;
        }
        throwAsPartOf(input, folder, refusal);
    }
}

}  // namespace asperity
