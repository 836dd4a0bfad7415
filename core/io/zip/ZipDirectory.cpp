#include "core/io/zip/ZipDirectory.h"

#include "core/io/ByteReader.h"

#include <algorithm>
#include <array>
#include <vector>

namespace asperity {

namespace {

constexpr std::string_view kLocalMark = "PK\3\4";
constexpr std::string_view kEntryMark = "PK\1\2";
constexpr std::string_view kEndMark = "PK\5\6";
constexpr std::string_view kLocatorMark = "PK\6\7";
constexpr std::string_view kEnd64Mark = "PK\6\6";
constexpr std::uint64_t kEndBytes = 22;
constexpr std::uint64_t kLocatorBytes = 20;
constexpr std::uint64_t kEnd64Bytes = 56;
constexpr std::uint64_t kMaxComment = 65536;  // of which libzip takes one byte more than can be
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

/// Where the end record at `end` says that the directory lies. Where a locator stands before it,
/// the 64-bit record alone counts, whatever the 32-bit fields say: that is how libzip reads them.
std::optional<ByteSpan> spanOf(const ByteSource& bytes, std::uint64_t end,
                               std::string_view endRecord) {
    const std::string locator =
        end < kLocatorBytes ? std::string()
                            : recordAt(bytes, {end - kLocatorBytes, kLocatorBytes}, kLocatorMark);
    if (locator.empty()) {
        return ByteSpan{littleEndian<std::uint32_t>(endRecord.data() + 16),
                        littleEndian<std::uint32_t>(endRecord.data() + 12)};
    }
    const std::string record =
        recordAt(bytes, {littleEndian<std::uint64_t>(locator.data() + 8), kEnd64Bytes}, kEnd64Mark);
    if (record.empty()) {
        return std::nullopt;
    }
    return ByteSpan{littleEndian<std::uint64_t>(record.data() + 48),
                    littleEndian<std::uint64_t>(record.data() + 40)};
}

bool isDirectory(const ByteSource& bytes, const ByteSpan& span) {
    return lies(span, bytes) &&
           (span.count == 0 ||
            !recordAt(bytes, {span.place, kEntryMark.size()}, kEntryMark).empty());
}

/// The directories that the file may have, from its front on: a comment or a stored entry can hold
/// another end record, and libzip reads what each of them lists.
std::vector<ByteSpan> directorySpans(const ByteSource& bytes) {
    const std::uint64_t searched = std::min(bytes.size(), kEndBytes + kMaxComment);
    const std::uint64_t start = bytes.size() - searched;
    const std::string tail = bytesOf(bytes, {start, searched});
    std::vector<ByteSpan> spans;
    for (std::size_t mark = tail.find(kEndMark);
         mark != std::string::npos && tail.size() - mark >= kEndBytes;
         mark = tail.find(kEndMark, mark + 1)) {
        const std::optional<ByteSpan> span =
            spanOf(bytes, start + mark, std::string_view(tail).substr(mark, kEndBytes));
        if (span && isDirectory(bytes, *span)) {
            spans.push_back(*span);
        }
    }
    return spans;
}

/// How many entries a directory lists up to the first that is damaged; more than `most` are not
/// counted.
std::uint64_t entriesIn(const ByteSource& bytes, const ByteSpan& span, std::uint64_t most) {
    constexpr std::size_t kNameLength = 28;
    constexpr std::size_t kExtraLength = 30;
    constexpr std::size_t kCommentLength = 32;
    ByteReader reader(bytes, span);
    std::array<char, 46> entry{};
    for (std::uint64_t count = 0;; ++count) {
        if (count > most || reader.remaining() < entry.size()) {
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

}  // namespace

bool isZip(const ByteSource& bytes) {
    return bytes.startsWith(kLocalMark) || bytes.startsWith(kEndMark);
}

std::optional<std::string> zipDirectory(const ByteSource& bytes) {
    const std::vector<ByteSpan> spans = directorySpans(bytes);
    if (spans.empty() || spans.back().count > kMaxDirectory) {
        return std::nullopt;
    }
    return bytesOf(bytes, spans.back());
}

bool zipListsMoreThan(std::uint64_t most, const ByteSource& bytes) {
    std::uint64_t count = 0;
    for (const ByteSpan& span : directorySpans(bytes)) {
        count += entriesIn(bytes, span, most - count);
        if (count > most) {
            return true;
        }
    }
    return false;
}

}  // namespace asperity
