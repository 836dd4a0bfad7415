#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// The whole content of a file.
/// @throw InputError when it is missing, a folder, no regular file, unreadable or empty
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& path);

/// A file whose bytes come into memory when they are looked at: for large scans.
class MappedFile {
public:
    /// @throw InputError as readFileBytes
    explicit MappedFile(const std::filesystem::path& path);
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    /// Valid as long as this object.
    [[nodiscard]] std::string_view bytes() const {
        return {static_cast<const char*>(memory_), size_};
    }
    /// Gives back the memory of what was looked at; a further look fetches it again.
    void forget() const noexcept;

private:
    std::size_t size_;
    void* memory_;
};

}  // namespace asperity
