#include "core/io/BufferedFile.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr std::uint64_t kSmall = std::uint64_t{1} << 22U;  // [bytes]

}  // namespace

BufferedFile::BufferedFile(const std::filesystem::path& path)
    : ByteSource(path.string()), file_(path) {
    if (file_.size() <= kSmall) {
        content_ = file_.start(file_.size());
    }
}

void BufferedFile::read(std::uint64_t place, std::span<char> bytes) const {
    if (place > content_.size() || bytes.size() > content_.size() - place) {
        file_.read(place, bytes);
        return;
    }
    std::copy_n(content_.data() + place, bytes.size(), bytes.data());
}

}  // namespace asperity
