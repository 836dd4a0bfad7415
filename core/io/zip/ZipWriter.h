#pragma once

#include "core/Progress.h"

#include <filesystem>
#include <memory>
#include <string>

namespace asperity {

/// Writes a zip archive, whole or not at all: until close() what was there stays.
class ZipWriter {
public:
    /// @throw Error where the archive cannot be made there
    explicit ZipWriter(const std::filesystem::path& path);
    /// Without close() all is as before.
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// @param name  of the entry, '/' between folders
    /// @param file  is read by close() @throw Error
    void addFile(const std::string& name, const std::filesystem::path& file);
    /// Puts the archive in place. @throw Error; Canceled
    void close(Progress* progress = nullptr);

private:
    class Archive;

    std::unique_ptr<Archive> archive_;
};

}  // namespace asperity
