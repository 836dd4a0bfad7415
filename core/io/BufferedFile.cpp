#include "core/io/BufferedFile.h"

#include "core/FreshMemory.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr std::uint64_t kSmall = std::uint64_t{1} << 17U;  // [bytes]

}  // namespace

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

void BufferedFile::read(std::uint64_t place, std::span<char> bytes) const {
    if (place > content_.size() || bytes.size() > content_.size() - place) {
        file_.read(place, bytes);
        return;
    }
    std::copy_n(content_.data() + place, bytes.size(), bytes.data());
}

}  // namespace asperity
