#include "core/Leftover.h"

#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <random>
#include <system_error>

namespace asperity {

namespace {

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
/// may have put it in place meanwhile.
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
    std::error_code failure;
    std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, failure);
    for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
        if (isTemporaryName(entry->path().filename().string(), prefix)) {
            sweep(entry->path());
        }
    }
}

}  // namespace asperity
