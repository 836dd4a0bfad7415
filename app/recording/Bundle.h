#pragma once

#include "core/Error.h"
#include "core/Progress.h"
#include "core/TemporaryFile.h"

#include <filesystem>
#include <optional>

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

/// Returns whether a file is a bundle, by its content.
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

/// Throws a refusal again by the name that the user gave: where it names a folder that a bundle was
/// unpacked into, the bundle and that part of it. Within a handler alone.
[[noreturn]] void throwAsPartOf(const std::filesystem::path& bundle,
                                const std::filesystem::path& folder, const FileError& refusal);

/// A run as a user names it: its folder, or a bundle, which is unpacked for as long as this lives.
class RunLocation {
public:
    /// @throw InputError where it is neither; Error
    explicit RunLocation(const std::filesystem::path& input);

    /// Returns the folder of the run's files.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Returns whether its files are from a bundle: the folder is deleted with this object.
    [[nodiscard]] bool isBundle() const { return unpacked_.has_value(); }

    /// Runs what reads the run's files. A refusal of one that is in a bundle names the bundle and
    /// that part of it, not the folder. @return what `work` returns @throw as `work`
    template <class Work>
    auto read(const Work& work) const {
        try {
            return work();
        } catch (const FileError& refusal) {
            if (!isBundle()) {
                throw;
            }
            throwAsPartOf(input_, folder_, refusal);
        }
    }

private:
    std::filesystem::path input_;
    std::optional<PrivateFolder> unpacked_;
    std::filesystem::path folder_;
};

/// The run that a file belongs to, as a user picks one in a dialog: the folder of a run's own
/// files; anything else as it is.
[[nodiscard]] std::filesystem::path runOf(const std::filesystem::path& file);

}  // namespace asperity
