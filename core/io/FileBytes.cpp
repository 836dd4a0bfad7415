#include "core/io/FileBytes.h"

#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/io/MemoryLimit.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

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

}  // namespace

// O_NONBLOCK: should a pipe have taken the path's place meanwhile.
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

void FileBytes::read(std::uint64_t place, std::span<char> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count =
            pread(file_.descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(place));
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            throw InputError(name(), "byte " + std::to_string(place),
                             "the file cannot be read: " + std::generic_category().message(errno));
        }
        if (count == 0) {
            throw InputError(name(), "byte " + std::to_string(place),
                             "the file became shorter while it was read; read it again when it "
                             "has been saved whole");
        }
        place += static_cast<std::uint64_t>(count);
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
    for (std::uint64_t place = 0; place < from.size(); place += piece.size()) {
        piece.resize(static_cast<std::size_t>(std::min(kPiece, from.size() - place)));
        from.read(place, piece);
        copy.append(piece);
    }
}

}  // namespace asperity
