#pragma once

#include <filesystem>
#include <string>

namespace asperity::test {

/// A folder of its own for one test, removed with what is in it.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return path_ / name; }
    /// Writes a file and returns its path.
    [[nodiscard]] std::filesystem::path write(const std::string& name,
                                              const std::string& content) const;

private:
    std::filesystem::path path_;
};

/// All bytes of a file; empty when it cannot be read.
[[nodiscard]] std::string contentOf(const std::filesystem::path& path);

}  // namespace asperity::test
