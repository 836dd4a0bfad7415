#pragma once

#include "core/Progress.h"

#include <filesystem>

namespace asperity {

/// A bundle is a zip archive of all that a run needs to be looked at and replayed on any machine:
/// the files of its folder, the scan itself in `scan/`, which its scene names, and `bundle.json`
/// with versions and the hash of each file. Unpacked, by whatever program, it is a run's folder.

/// @param run     folder of a run that is complete
/// @param picture of it, picture.png in the bundle; empty: none
/// @throw Error where the bundle cannot be written; InputError where the scan is missing or not the
/// one that the run was made on; Canceled
void writeBundle(const std::filesystem::path& run, const std::filesystem::path& picture,
                 const std::filesystem::path& bundle, Progress* progress = nullptr);

/// Whether a file is one, by its content.
[[nodiscard]] bool isBundle(const std::filesystem::path& file);

/// Writes the files of a bundle into a folder that is there; nothing else that it may hold.
/// @throw InputError where it is no bundle, or a file of it is missing or damaged; Error; Canceled
void unpackBundle(const std::filesystem::path& bundle, const std::filesystem::path& folder,
                  Progress* progress = nullptr);

/// The same into a folder of `parent` that is named by its content, where it stays: a scene that is
/// opened from it names its scan there. One that is there already is used again.
/// @return the folder @throw as unpackBundle()
[[nodiscard]] std::filesystem::path keptBundle(const std::filesystem::path& bundle,
                                               const std::filesystem::path& parent,
                                               Progress* progress = nullptr);

}  // namespace asperity
