#pragma once

#include "core/io/FileBytes.h"

#include <filesystem>
#include <string>

namespace asperity {

/// A file of which many small parts are read. A small one is read whole when it is opened: a copy
/// costs less than a call for each part. A large one stays where it is.
class BufferedFile final : public ByteSource {
public:
    /// @throw InputError as FileBytes
    explicit BufferedFile(const std::filesystem::path& path);

    [[nodiscard]] std::uint64_t size() const override { return file_.size(); }
    void read(std::uint64_t place, std::span<char> bytes) const override;
    void requireUnchanged() const override { file_.requireUnchanged(); }

private:
    FileBytes file_;
    std::string content_;  ///< empty where the file is large
};

}  // namespace asperity
