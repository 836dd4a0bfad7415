#pragma once

#include "core/Progress.h"
#include "core/io/ByteReader.h"

#include <filesystem>
#include <memory>
#include <openssl/types.h>
#include <span>
#include <string>
#include <sys/stat.h>

namespace asperity {

/// The whole content of a file.
/// @throw InputError when it is missing, a folder, no regular file, unreadable or empty, or becomes
///        shorter
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

/// A file that stays open while it is read. Another one that gets its name changes nothing.
class FileBytes final : public ByteSource {
public:
    /// @throw InputError as readFileBytes()
    explicit FileBytes(const std::filesystem::path& path) : FileBytes(path, path.string()) {}
    /// @param name for messages
    FileBytes(const std::filesystem::path& path, const std::string& name);

    [[nodiscard]] std::uint64_t size() const override {
        return static_cast<std::uint64_t>(opened_.st_size);
    }
    void read(std::uint64_t offset, std::span<char> bytes) const override;
    /// Compares size and time stamps, which a write within the same few milliseconds may leave
    /// alike.
    void requireUnchanged() const override;

private:
    [[nodiscard]] struct stat status() const;

    OpenFile file_;
    struct stat opened_;  ///< when it was opened
};

/// A file of which many small parts are read. A small one is read whole when it is opened: a copy
/// costs less than a call for each part. A large one stays where it is.
class BufferedFile final : public ByteSource {
public:
    /// @throw InputError as FileBytes
    explicit BufferedFile(const std::filesystem::path& path);

    [[nodiscard]] std::uint64_t size() const override { return file_.size(); }
    void read(std::uint64_t offset, std::span<char> bytes) const override;
    void requireUnchanged() const override { file_.requireUnchanged(); }

private:
    FileBytes file_;
    std::string content_;  ///< empty where the file is large
};

/// SHA-256 of a content that comes piece by piece.
class Sha256 {
public:
    Sha256();

    void add(std::span<const char> bytes);
    /// 64 lower-case hexadecimal digits; nothing can be added after it.
    [[nodiscard]] std::string digits();

private:
    std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

/// SHA-256 of a content. @throw InputError when it cannot be read or changes; Canceled
[[nodiscard]] std::string sha256Of(const ByteSource& source, Progress* progress = nullptr);

/// MD5 of a content, 32 lower-case hexadecimal digits: file formats carry it against damage, it
/// proves no origin. Empty where the OpenSSL library is set up to refuse it.
/// @throw InputError as sha256Of()
[[nodiscard]] std::string md5Of(const ByteSource& source);

}  // namespace asperity
