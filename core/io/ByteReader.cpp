#include "core/io/ByteReader.h"

#include "core/Error.h"

namespace asperity {

namespace {

constexpr std::uint64_t kWindowBytes = 4096;
constexpr std::uint64_t kMaxNameLength = 65536;

}  // namespace

std::string bytesOf(const ByteSource& source, const ByteSpan& span) {
    std::string bytes(static_cast<std::size_t>(span.count), '\0');
    source.read(span.place, bytes);
    return bytes;
}

ByteSpan ByteReader::take(std::uint64_t count, std::string_view what) {
    if (count > remaining()) {
        fail("expected " + std::to_string(count) + " bytes of " + std::string(what) +
             ", but only " + std::to_string(remaining()) +
             " are left; the file is truncated or damaged");
    }
    const ByteSpan taken{place_, count};
    place_ += count;
    return taken;
}

ByteSpan ByteReader::takeString(std::string_view what) {
    for (std::uint64_t searched = place_; searched < end_;) {
        const std::string_view bytes = window(searched, 1);
        const std::size_t found = bytes.find('\0');
        if (found != std::string_view::npos) {
            const ByteSpan taken{place_, searched + found - place_};
            place_ = taken.end() + 1;
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
        place_ = span.place;
        fail("expected " + std::string(what) + " of at most " + std::to_string(kMaxNameLength) +
             " bytes; the file is damaged");
    }
    return span.count == 0 ? std::string()
                           : std::string(window(span.place, span.count).substr(0, span.count));
}

void ByteReader::copy(std::span<char> bytes, std::string_view what) {
    const ByteSpan span = take(bytes.size(), what);
    if (bytes.size() > kWindowBytes) {
        source_->read(span.place, bytes);
        return;
    }
    std::ranges::copy(window(span.place, span.count).substr(0, bytes.size()), bytes.begin());
}

void ByteReader::fail(std::string_view message) const {
    throw InputError(source_->name(), "byte " + std::to_string(place_), std::string(message));
}

std::string_view ByteReader::window(std::uint64_t place, std::uint64_t least) {
    const bool held = place >= windowPlace_ && place + least <= windowPlace_ + window_.size();
    if (!held) {
        const std::uint64_t count = std::min(std::max(least, kWindowBytes), end_ - place);
        window_ = bytesOf(*source_, {place, count});
        windowPlace_ = place;
    }
    return std::string_view(window_).substr(static_cast<std::size_t>(place - windowPlace_));
}

}  // namespace asperity
