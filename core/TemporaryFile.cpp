#include "core/TemporaryFile.h"

#include "core/Error.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <fcntl.h>
#include <random>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace asperity {

namespace {

std::string reasonOf(int error) { return std::generic_category().message(error); }

/// Follows symbolic links. @throw FileError when the file cannot be there
std::filesystem::path locationOf(const std::filesystem::path& target) {
    std::error_code failure;
    const std::filesystem::file_type kind = std::filesystem::status(target, failure).type();
    if (kind == std::filesystem::file_type::not_found) {
        return std::filesystem::is_symlink(std::filesystem::symlink_status(target, failure))
                   ? locationOf(target.parent_path() / std::filesystem::read_symlink(target))
                   : target;
    }
    if (failure) {
        throw FileError(target.string(), "cannot be written: " + failure.message());
    }
    if (kind != std::filesystem::file_type::regular) {
        throw FileError(target.string(), "cannot be written: it is there and no regular file");
    }
    return std::filesystem::canonical(target);
}

/// The writer opens the file once more, and would take the refusal for a full disk.
bool canOpenAnother(const FileDescriptor& file) {
    return FileDescriptor(fcntl(file.get(), F_DUPFD_CLOEXEC, 0)).isOpen();
}

constexpr mode_t kOwnerOnly = 0700;

std::filesystem::path parentFolder() {
    std::error_code failure;
    std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
    if (failure) {
        throw FileError(parent.empty() ? "TMPDIR" : parent.string(),
                        "there is no folder for temporary files; is TMPDIR right?");
    }
    return parent;
}

constexpr std::string_view kStart = ".asperity-";
constexpr std::string_view kSuffix = ".part";
constexpr int kSuffixDigits = 16;

std::string hexadecimal(std::uint64_t number) {
    std::string text;
    for (int shift = 4 * (kSuffixDigits - 1); shift >= 0; shift -= 4) {
        text += "0123456789abcdef"[(number >> static_cast<unsigned>(shift)) & 0xFU];
    }
    return text;
}

/// FNV-1a; http://www.isthe.com/chongo/tech/comp/fnv/
std::uint64_t hashOf(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
    return hash;
}

constexpr std::size_t kEndBytes = kSuffixDigits + kSuffix.size();  // of a name, after its prefix

bool isTemporaryName(std::string_view name, std::string_view prefix) {
    return name.size() == prefix.size() + kEndBytes && name.starts_with(prefix) &&
           name.ends_with(kSuffix);
}

/// The lock says that nobody writes it any more; then it is looked at again, since whoever made it
/// may have put it in place since.
void sweep(const std::filesystem::path& path) {
    const FileDescriptor found(
        open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    struct stat kind {};
    if (!found.isOpen() || fstat(found.get(), &kind) != 0 || kind.st_uid != geteuid() ||
        !(S_ISREG(kind.st_mode) || S_ISDIR(kind.st_mode))) {
        return;
    }
    if (found.lock() && found.isAt(path)) {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
}

}  // namespace

TemporaryFolder::TemporaryFolder(const std::filesystem::path& parent, std::string_view purpose,
                                 mode_t mode) {
    const std::string prefix = temporaryPrefix(purpose);
    sweepLeftovers(parent, prefix);
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        path_ = parent / temporaryName(prefix);
        if (mkdir(path_.c_str(), mode) != 0) {
            if (errno == EEXIST) {
                continue;
            }
            break;
        }
        lock_ =
            FileDescriptor(open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (lock_.isOpen() && holdTemporary(lock_, path_)) {
            return;
        }
        // One that is missing was swept by another process before it was locked.
        if (!lock_.isOpen() && errno != ENOENT) {
            const int failure = errno;
            rmdir(path_.c_str());
            errno = failure;
            break;
        }
        // A sweeper and this thread wait for the same folder, and would stay in step.
        std::this_thread::sleep_for(std::chrono::microseconds(10 * i));
    }
    const std::string reason = std::generic_category().message(errno);
    throw FileError(parent.string(), "cannot be written: " + reason);
}

TemporaryFolder::~TemporaryFolder() {
    // Locked: a sweeper that removes the same files stops this half-way.
    std::error_code failure;
    std::filesystem::remove_all(path_, failure);
    if (failure) {
        lock_ = FileDescriptor(-1);  // where no file can be opened any more, one is needed
        std::filesystem::remove_all(path_, failure);
    }
}

TemporaryFile::TemporaryFile(std::filesystem::path target)
    : target_(std::move(target)), location_(locationOf(target_)), file_(created()) {}

/// Names the file and creates it; deletes what was left for the same target first.
FileDescriptor TemporaryFile::created() {
    constexpr mode_t kAsUmaskSays = 0666;
    constexpr int kTries = 100;
    const std::string prefix = temporaryPrefix(location_.filename().string());
    sweepLeftovers(location_.parent_path(), prefix);
    for (int i = 0; i < kTries; ++i) {
        path_ = location_.parent_path() / temporaryName(prefix);
        FileDescriptor file(open(
            path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kAsUmaskSays));
        if (file.isOpen() && !canOpenAnother(file)) {
            std::error_code ignored;
            std::filesystem::remove(path_, ignored);
            throw FileError(target_.string(), "cannot be written: " + reasonOf(EMFILE));
        }
        if (file.isOpen() && holdTemporary(file, path_)) {
            return file;
        }
        if (!file.isOpen() && errno != EEXIST) {
            break;
        }
    }
    throw FileError(target_.string(),
                    "cannot be written: " +
                        (errno == ENOENT ? "its folder is missing" : reasonOf(errno)));
}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void TemporaryFile::sync() const {
    if (fsync(file_.get()) != 0) {
        throw Error(target_.string() + ": cannot be written: " + reasonOf(errno));
    }
}

void TemporaryFile::commit() const {
    std::error_code failure;
    std::filesystem::rename(path_, location_, failure);
    if (failure) {
        throw Error(target_.string() + ": cannot be moved here: " + failure.message());
    }
}

void requireWritable(const std::filesystem::path& target) { const TemporaryFile probe(target); }

OutputFile::OutputFile(std::filesystem::path target)
    : file_(std::move(target)), stream_(file_.path(), std::ios::binary) {}

void OutputFile::close() {
    stream_.close();
    if (!stream_) {
        throw Error(file_.target().string() + ": writing stopped half-way (disk full?)");
    }
}

void OutputFile::commit() {
    close();
    file_.commit();
}

void OutputFile::commitToDisk() {
    close();
    file_.sync();
    file_.commit();
}

PrivateFolder::PrivateFolder() : folder_(parentFolder(), "private", kOwnerOnly) {}

std::string temporaryPrefix(std::string_view purpose) {
    constexpr std::size_t kPrefixBytes = kStart.size() + kSuffixDigits + 1;
    if (purpose.size() == kPrefixBytes + kEndBytes) {
        const std::string_view prefix = purpose.substr(0, kPrefixBytes);
        if (prefix.starts_with(kStart) && isTemporaryName(purpose, prefix)) {
            return std::string(prefix);
        }
    }
    return std::string(kStart) + hexadecimal(hashOf(purpose)) + "-";
}

std::string temporaryName(const std::string& prefix) {
    std::random_device random;
    const std::uint64_t high = random();
    return prefix + hexadecimal((high << 32U) | random()) + std::string(kSuffix);
}

bool holdTemporary(const FileDescriptor& made, const std::filesystem::path& path) {
    // A file system without locks has no sweepers.
    const bool held = made.lock() || errno != EWOULDBLOCK;
    return held && made.isAt(path);
}

void sweepLeftovers(const std::filesystem::path& folder, const std::string& prefix) {
    // Listed first: a listing gives what is made while it goes on, too, and a sweep would run after
    // the tries of a process that makes one.
    std::vector<std::filesystem::path> found;
    std::error_code failure;
    std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, failure);
    for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
        if (isTemporaryName(entry->path().filename().string(), prefix)) {
            found.push_back(entry->path());
        }
    }
    std::ranges::for_each(found, sweep);
}

}  // namespace asperity
