#pragma once

#include "core/FileDescriptor.h"

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace asperity {

/// A file that grows in its final place, new or with what an earlier one left: what was appended
/// stays, whatever ends the program. While it is open it is locked, so that others can tell whether
/// somebody still writes it.
class GrowingFile {
public:
    /// @throw Error when it cannot be made, or there is something of this name
    explicit GrowingFile(std::filesystem::path path);
    /// Goes on with a file that is there, after its first `kept` bytes: the rest is dropped.
    /// @throw Error when it cannot be opened, or another process holds it open
    GrowingFile(std::filesystem::path path, std::uint64_t kept);

    /// All of it, into the hands of the system: a killed process loses nothing of it.
    /// @throw Error with the system's reason, such as a full disk; a part may be written
    void append(std::string_view bytes);
    /// Waits until the disk holds what was appended: a power cut loses nothing of it. @throw Error
    void sync() const;

private:
    std::filesystem::path path_;
    FileDescriptor file_;
};

/// Whether some process holds a GrowingFile of this path open.
[[nodiscard]] bool isGrowing(const std::filesystem::path& path);

/// Waits until the disk holds a file or a folder's list of files; in good faith, no promise.
void syncToDisk(const std::filesystem::path& path) noexcept;

}  // namespace asperity
