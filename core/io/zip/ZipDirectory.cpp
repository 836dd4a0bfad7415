#include "core/io/zip/ZipDirectory.h"

#include "core/io/ByteReader.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

constexpr std::string_view kLocalMark = "PK\3\4";
constexpr std::string_view kEndMark = "PK\5\6";
constexpr std::string_view kLocatorMark = "PK\6\7";
constexpr std::string_view kEnd64Mark = "PK\6\6";
constexpr std::uint64_t kEndBytes = 22;
constexpr std::uint64_t kLocatorBytes = 20;
constexpr std::uint64_t kEnd64Bytes = 56;
constexpr std::uint64_t kMaxComment = 65535;
constexpr std::uint32_t kIn64BitRecord = 0xFFFFFFFF;
/// A million entries.
constexpr std::uint64_t kMaxDirectory = std::uint64_t{1} << 27U;

bool lies(const ByteSpan& span, const ByteSource& bytes) {
    return span.place <= bytes.size() && span.count <= bytes.size() - span.place;
}

/// The record of `count` bytes with this mark; empty when it is not there.
std::string recordAt(const ByteSource& bytes, const ByteSpan& span, std::string_view mark) {
    std::string record = lies(span, bytes) ? bytesOf(bytes, span) : std::string();
    return record.starts_with(mark) ? record : std::string();
}

/// Where an archive of more than 4 GiB or 65535 entries has its directory.
std::optional<ByteSpan> directory64(const ByteSource& bytes, std::uint64_t end) {
    if (end < kLocatorBytes) {
        return std::nullopt;
    }
    const std::string locator = recordAt(bytes, {end - kLocatorBytes, kLocatorBytes}, kLocatorMark);
    if (locator.empty()) {
        return std::nullopt;
    }
    const std::string record =
        recordAt(bytes, {littleEndian<std::uint64_t>(locator.data() + 8), kEnd64Bytes}, kEnd64Mark);
    if (record.empty()) {
        return std::nullopt;
    }
    return ByteSpan{littleEndian<std::uint64_t>(record.data() + 48),
                    littleEndian<std::uint64_t>(record.data() + 40)};
}

std::optional<ByteSpan> directorySpan(const ByteSource& bytes) {
    const std::uint64_t searched = std::min(bytes.size(), kEndBytes + kMaxComment);
    const std::string tail = bytesOf(bytes, {bytes.size() - searched, searched});
    const std::size_t mark = tail.rfind(kEndMark);
    if (mark == std::string::npos || tail.size() - mark < kEndBytes) {
        return std::nullopt;
    }
    const char* const end = tail.data() + mark;
    const ByteSpan span{littleEndian<std::uint32_t>(end + 16),
                        littleEndian<std::uint32_t>(end + 12)};
    if (span.place == kIn64BitRecord || span.count == kIn64BitRecord) {
        return directory64(bytes, bytes.size() - searched + mark);
    }
    return span;
}

}  // namespace

bool isZip(const ByteSource& bytes) {
    return bytes.startsWith(kLocalMark) || bytes.startsWith(kEndMark);
}

std::optional<std::string> zipDirectory(const ByteSource& bytes) {
    const std::optional<ByteSpan> span = directorySpan(bytes);
    if (!span || span->count > kMaxDirectory || !lies(*span, bytes)) {
        return std::nullopt;
    }
    return bytesOf(bytes, *span);
}

std::uint64_t zipEntryCount(const ByteSource& bytes) {
    constexpr std::string_view kEntryMark = "PK\1\2";
    constexpr std::size_t kNameLength = 28;
    constexpr std::size_t kExtraLength = 30;
    constexpr std::size_t kCommentLength = 32;
    const std::optional<ByteSpan> span = directorySpan(bytes);
    if (!span || !lies(*span, bytes)) {
        return 0;
    }
    ByteReader reader(bytes, *span);
    std::array<char, 46> entry{};
    for (std::uint64_t count = 0;; ++count) {
        if (reader.remaining() < entry.size()) {
            return count;
        }
        reader.copy(entry, "an entry");
        std::uint64_t rest = 0;
        for (const std::size_t length : {kNameLength, kExtraLength, kCommentLength}) {
            rest += littleEndian<std::uint16_t>(entry.data() + length);
        }
        if (std::string_view(entry.data(), kEntryMark.size()) != kEntryMark ||
            rest > reader.remaining()) {
            return count;
        }
        (void)reader.take(rest, "an entry");
    }
}

}  // namespace asperity
