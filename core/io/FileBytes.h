#pragma once

#include "core/io/ByteSource.h"

#include <filesystem>
#include <string>
#include <sys/stat.h>

namespace asperity {

/// The whole content of a file.
/// @throw InputError when it is missing, a folder, no regular file, unreadable or empty, or becomes
///        shorter meanwhile
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path);

/// Copies a whole content into a file, piece by piece. @throw Error when it cannot be written; as
/// ByteSource::read()
void copyTo(const ByteSource& from, const std::filesystem::path& file);

/// A file descriptor for reading that is closed at the end of its scope.
class OpenFile {
public:
    explicit OpenFile(const std::filesystem::path& path);
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile();

    [[nodiscard]] int descriptor() const { return descriptor_; }  ///< negative: it is not open

private:
    int descriptor_;
};

/// A file that stays open while it is read. Another one that takes its name changes nothing.
class FileBytes final : public ByteSource {
public:
    /// @throw InputError as readFileBytes()
    explicit FileBytes(const std::filesystem::path& path) : FileBytes(path, path.string()) {}
    /// @param name for messages
    FileBytes(const std::filesystem::path& path, const std::string& name);

    [[nodiscard]] std::uint64_t size() const override {
        return static_cast<std::uint64_t>(opened_.st_size);
    }
    void read(std::uint64_t place, std::span<char> bytes) const override;
    /// By size and time stamps, which a write within the same few milliseconds may leave alike.
    void requireUnchanged() const override;

private:
    [[nodiscard]] struct stat status() const;

    OpenFile file_;
    struct stat opened_;  ///< when it was opened
};

}  // namespace asperity
