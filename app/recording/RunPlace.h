#pragma once

#include "core/Error.h"
#include "core/PrivateFolder.h"

#include <filesystem>
#include <optional>

namespace asperity {

/// Throws a refusal again by the name that the user gave: where it names a folder that a bundle was
/// unpacked into, the bundle and that part of it. Within a handler alone.
[[noreturn]] void throwAsPartOf(const std::filesystem::path& bundle,
                                const std::filesystem::path& folder, const FileError& refusal);

/// A run as a user names it: its folder, or a bundle, which is unpacked for as long as this lives.
class RunPlace {
public:
    /// @throw InputError where it is neither; Error
    explicit RunPlace(const std::filesystem::path& input);

    /// That a run's files are in.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Whether its files are in a bundle, and the folder goes with this.
    [[nodiscard]] bool isBundle() const { return unpacked_.has_value(); }

    /// Runs what reads the run's files. A refusal of one that is in a bundle names the bundle and
    /// that part of it, not the folder that goes. @return what `work` returns @throw as `work`
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
