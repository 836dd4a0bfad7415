#include "core/io/FileBytes.h"

#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/io/MemoryLimit.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <openssl/evp.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace asperity {

namespace {

/// Looks at the path before it is opened: a pipe would hang, a device may act.
const std::filesystem::path& requireRegular(const std::filesystem::path& path,
                                            const std::string& name) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw InputError(name, "", "there is no such file");
    }
    if (std::filesystem::is_directory(status)) {
        throw InputError(name, "", "this is a folder; a file is expected");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(name, "", "this is not a regular file");
    }
    return path;
}

bool areSame(const timespec& one, const timespec& other) {
    return one.tv_sec == other.tv_sec && one.tv_nsec == other.tv_nsec;
}

constexpr std::uint64_t kSmall = std::uint64_t{1} << 17U;  // [bytes]

constexpr std::uint64_t kBlockBytes = 65536;

using Context = std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)>;

Context newContext() { return {EVP_MD_CTX_new(), EVP_MD_CTX_free}; }

void require(int succeeded) {
    if (succeeded != 1) {
        throw Error("a hash cannot be computed by the OpenSSL library");
    }
}

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += kDigits[bytes[i] >> 4U];
        text += kDigits[bytes[i] & 0xFU];
    }
    return text;
}

std::string digitsOf(EVP_MD_CTX& context) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    require(EVP_DigestFinal_ex(&context, digest.data(), &length));
    return hexadecimal(digest.data(), length);
}

std::string digestOf(const ByteSource& source, EVP_MD_CTX& context, Progress* progress) {
    std::vector<char> block(kBlockBytes);
    const std::uint64_t size = source.size();
    const std::uint64_t step = (size / kBlockBytes / 32 + 1) * kBlockBytes;
    for (std::uint64_t offset = 0; offset < size; offset += block.size()) {
        if (offset % step == 0) {
            reportTo(progress, static_cast<double>(offset) / static_cast<double>(size));
        }
        block.resize(static_cast<std::size_t>(std::min(kBlockBytes, size - offset)));
        source.read(offset, block);
        require(EVP_DigestUpdate(&context, block.data(), block.size()));
    }
    source.requireUnchanged();
    return digitsOf(context);
}

}  // namespace

// O_NONBLOCK: should a pipe be at the path now.
OpenFile::OpenFile(const std::filesystem::path& path)
    : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}

OpenFile::~OpenFile() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

FileBytes::FileBytes(const std::filesystem::path& path, const std::string& name)
    : ByteSource(name), file_(requireRegular(path, name)), opened_{} {
    if (file_.descriptor() < 0) {
        throw InputError(name, "",
                         "the file cannot be opened for reading: " +
                             std::generic_category().message(errno));
    }
    opened_ = status();
    if (!S_ISREG(opened_.st_mode)) {
        throw InputError(name, "", "this is not a regular file");
    }
    if (opened_.st_size == 0) {
        throw InputError(name, "", "the file is empty");
    }
    // Advice only.
    (void)posix_fadvise(file_.descriptor(), 0, 0, POSIX_FADV_SEQUENTIAL);
}

void FileBytes::read(std::uint64_t offset, std::span<char> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count =
            pread(file_.descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            throw InputError(name(), "byte " + std::to_string(offset),
                             "the file cannot be read: " + std::generic_category().message(errno));
        }
        if (count == 0) {
            throw InputError(name(), "byte " + std::to_string(offset),
                             "the file became shorter while it was read; read it again when it "
                             "has been saved whole");
        }
        offset += static_cast<std::uint64_t>(count);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

void FileBytes::requireUnchanged() const {
    const struct stat now = status();
    if (now.st_size != opened_.st_size || !areSame(now.st_mtim, opened_.st_mtim)) {
        throw InputError(name(), "",
                         "the file was changed while it was read; read it again when it has been "
                         "saved whole");
    }
}

struct stat FileBytes::status() const {
    struct stat result {};
    if (fstat(file_.descriptor(), &result) != 0) {
        throw InputError(name(), "", "its size cannot be read");
    }
    return result;
}

std::string readFileBytes(const std::filesystem::path& path) {
    const FileBytes file(path);
    std::string bytes;
    requireMemory(file.size(), path.string(), "");
    bytes = file.start(file.size());
    file.requireUnchanged();
    return bytes;
}

void copyTo(const ByteSource& from, const std::filesystem::path& file) {
    constexpr std::uint64_t kPiece = std::uint64_t{1} << 20U;
    GrowingFile copy(file);
    std::string piece;
    for (std::uint64_t offset = 0; offset < from.size(); offset += piece.size()) {
        piece.resize(static_cast<std::size_t>(std::min(kPiece, from.size() - offset)));
        from.read(offset, piece);
        copy.append(piece);
    }
}

BufferedFile::BufferedFile(const std::filesystem::path& path)
    : ByteSource(path.string()), file_(path) {
    if (file_.size() <= kSmall) {
        const auto size = static_cast<std::size_t>(file_.size());
        content_.reserve(size);
        requestPages(content_.data(), size);
        content_.resize(size);
        file_.read(0, content_);
    }
}

void BufferedFile::read(std::uint64_t offset, std::span<char> bytes) const {
    if (offset > content_.size() || bytes.size() > content_.size() - offset) {
        file_.read(offset, bytes);
        return;
    }
    std::copy_n(content_.data() + offset, bytes.size(), bytes.data());
}

Sha256::Sha256() : context_(newContext()) {
    require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::add(std::span<const char> bytes) {
    require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digits() { return digitsOf(*context_); }

std::string sha256Of(const ByteSource& source, Progress* progress) {
    const Context context = newContext();
    require(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
    return digestOf(source, *context, progress);
}

std::string md5Of(const ByteSource& source) {
    const Context context = newContext();
    if (EVP_DigestInit_ex(context.get(), EVP_md5(), nullptr) != 1) {
        return {};
    }
    return digestOf(source, *context, nullptr);
}

}  // namespace asperity
