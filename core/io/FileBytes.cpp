#include "core/io/FileBytes.h"

#include "core/Error.h"

#include <fcntl.h>
#include <fstream>
#include <sys/mman.h>
#include <unistd.h>

namespace asperity {

namespace {

/// Looks at the path before opening it: a folder or a pipe would hang or give confusing errors.
std::uintmax_t checkedSize(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw InputError(path.string(), "", "there is no such file");
    }
    if (std::filesystem::is_directory(status)) {
        throw InputError(path.string(), "", "this is a folder; a file is expected");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(path.string(), "", "this is not a regular file");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) {
        throw InputError(path.string(), "", "its size cannot be read");
    }
    if (size == 0) {
        throw InputError(path.string(), "", "the file is empty");
    }
    return size;
}

/// A file descriptor that is closed at the end of its scope.
class OpenFile {
public:
    explicit OpenFile(const std::filesystem::path& path)
        : descriptor_(open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor_ >= 0) {
            close(descriptor_);
        }
    }

    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

void* mapped(const std::filesystem::path& path, std::size_t size) {
    const OpenFile file(path);
    if (file.descriptor() < 0) {
        throw InputError(path.string(), "", "the file cannot be opened for reading");
    }
    void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.descriptor(), 0);
    if (memory == MAP_FAILED) {
        throw InputError(path.string(), "", "the file cannot be brought into memory");
    }
    // Advice only.
    (void)madvise(memory, size, MADV_SEQUENTIAL);
    return memory;
}

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& path)
    : size_(static_cast<std::size_t>(checkedSize(path))), memory_(mapped(path, size_)) {}

MappedFile::~MappedFile() { munmap(memory_, size_); }

void MappedFile::forget() const noexcept { (void)madvise(memory_, size_, MADV_DONTNEED); }

std::string readFileBytes(const std::filesystem::path& path) {
    const std::uintmax_t size = checkedSize(path);
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw InputError(path.string(), "", "the file cannot be opened for reading");
    }
    std::string bytes;
    if (size > bytes.max_size()) {
        throw InputError(path.string(), "", "the file is too large for memory");
    }
    bytes.resize(static_cast<std::size_t>(size));
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
        throw InputError(path.string(), "byte " + std::to_string(stream.gcount()),
                         "the file cannot be read to its end");
    }
    return bytes;
}

}  // namespace asperity
