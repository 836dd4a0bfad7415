#include "core/io/ByteReader.h"

#include "core/Error.h"

namespace asperity {

namespace {

constexpr std::uint64_t kWindowBytes = 4096;
constexpr std::uint64_t kMaxNameLength = 65536;

}  // namespace

std::string ByteSource::start(std::uint64_t most) const {
    std::string bytes(static_cast<std::size_t>(std::min(most, size())), '\0');
    read(0, bytes);
    return bytes;
}

std::string ByteSource::startUntil(const std::function<bool(std::string_view)>& areEnough,
                                   std::uint64_t most) const {
    constexpr std::size_t kFirst = std::size_t{1} << 14U;
    const auto last = static_cast<std::size_t>(std::min(most, size()));
    std::string bytes = start(std::min(kFirst, last));
    while (bytes.size() < last && !areEnough(bytes)) {
        const std::size_t before = bytes.size();
        bytes.resize(std::min(2 * before, last));
        read(before, std::span(bytes).subspan(before));
    }
    return bytes;
}

void MemoryBytes::read(std::uint64_t offset, std::span<char> bytes) const {
    if (offset > bytes_.size() || bytes.size() > bytes_.size() - offset) {
        throw InputError(name(), "byte " + std::to_string(bytes_.size()),
                         "the content ends here; it is truncated or damaged");
    }
    std::ranges::copy(bytes_.substr(static_cast<std::size_t>(offset), bytes.size()), bytes.begin());
}

std::string bytesOf(const ByteSource& source, const ByteSpan& span) {
    std::string bytes(static_cast<std::size_t>(span.count), '\0');
    source.read(span.offset, bytes);
    return bytes;
}

ByteSpan ByteReader::take(std::uint64_t count, std::string_view what) {
    if (count > remaining()) {
        fail("expected " + std::to_string(count) + " bytes of " + std::string(what) +
             ", but only " + std::to_string(remaining()) +
             " are left; the file is truncated or damaged");
    }
    const ByteSpan taken{offset_, count};
    offset_ += count;
    return taken;
}

ByteSpan ByteReader::takeString(std::string_view what) {
    for (std::uint64_t searched = offset_; searched < end_;) {
        const std::string_view bytes = window(searched, 1);
        const std::size_t found = bytes.find('\0');
        if (found != std::string_view::npos) {
            const ByteSpan taken{offset_, searched + found - offset_};
            offset_ = taken.end() + 1;
            return taken;
        }
        searched += bytes.size();
    }
    fail("expected " + std::string(what) +
         " that ends with a NUL byte; the file is truncated or damaged");
}

std::string ByteReader::takeName(std::string_view what) {
    const ByteSpan span = takeString(what);
    if (span.count > kMaxNameLength) {
        offset_ = span.offset;
        fail("expected " + std::string(what) + " of at most " + std::to_string(kMaxNameLength) +
             " bytes; the file is damaged");
    }
    return span.count == 0 ? std::string()
                           : std::string(window(span.offset, span.count).substr(0, span.count));
}

void ByteReader::copy(std::span<char> bytes, std::string_view what) {
    const ByteSpan span = take(bytes.size(), what);
    if (bytes.size() > kWindowBytes) {
        source_->read(span.offset, bytes);
        return;
    }
    std::ranges::copy(window(span.offset, span.count).substr(0, bytes.size()), bytes.begin());
}

void ByteReader::fail(std::string_view message) const {
    throw InputError(source_->name(), "byte " + std::to_string(offset_), std::string(message));
}

std::string_view ByteReader::window(std::uint64_t offset, std::uint64_t least) {
    const bool held = offset >= windowOffset_ && offset + least <= windowOffset_ + window_.size();
    if (!held) {
        const std::uint64_t count = std::min(std::max(least, kWindowBytes), end_ - offset);
        window_ = bytesOf(*source_, {offset, count});
        windowOffset_ = offset;
    }
    return std::string_view(window_).substr(static_cast<std::size_t>(offset - windowOffset_));
}

}  // namespace asperity
