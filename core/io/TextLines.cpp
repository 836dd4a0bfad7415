#include "core/io/TextLines.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr std::uint64_t kChunk = std::uint64_t{1} << 18U;  // [bytes]
constexpr std::size_t kMaxLine = std::size_t{1} << 23U;    // [bytes]

/// Returns whether lines end with a CR alone, as those of old Macintosh programs.
bool endsWithReturn(std::string_view text) {
    const std::size_t first = text.find_first_of("\r\n");
    return first != std::string_view::npos && first + 1 < text.size() && text[first] == '\r' &&
           text[first + 1] != '\n';
}

/// Returns whether the last character of a chunk of UTF-16 is the first half of a pair.
bool endsInsidePair(std::string_view chunk, std::endian order) {
    const char high = chunk[chunk.size() - (order == std::endian::little ? 1 : 2)];
    return (static_cast<unsigned char>(high) & 0xFCU) == 0xD8U;
}

}  // namespace

TextLines::TextLines(const ByteSource& bytes) : bytes_(bytes) {
    if (bytes.startsWith("\xEF\xBB\xBF")) {
        offset_ = 3;
    } else if (bytes.startsWith("\xFF\xFE")) {
        encoding_ = Encoding::Utf16Little;
        offset_ = 2;
    } else if (bytes.startsWith("\xFE\xFF")) {
        encoding_ = Encoding::Utf16Big;
        offset_ = 2;
    }
    (void)readMore();
    lineEnd_ = endsWithReturn(text_) ? '\r' : '\n';
}

std::optional<std::string_view> TextLines::next() {
    std::size_t searched = begin_;
    for (;;) {
        const std::size_t end = text_.find(lineEnd_, searched);
        if (end != std::string::npos) {
            return take(end, end + 1);
        }
        if (text_.size() - begin_ > kMaxLine) {
            ++number_;
            fail("it is longer than " + std::to_string(kMaxLine) + " bytes");
        }
        searched = text_.size() - begin_;
        const bool more = readMore();
        if (!more && begin_ == text_.size()) {
            return std::nullopt;
        }
        if (!more) {
            return take(text_.size(), text_.size());
        }
    }
}

std::string_view TextLines::take(std::size_t end, std::size_t next) {
    const std::size_t begin = begin_;
    begin_ = next;
    ++number_;
    std::string_view line = std::string_view(text_).substr(begin, end - begin);
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

bool TextLines::readMore() {
    const std::uint64_t count = std::min(kChunk, bytes_.size() - std::min(offset_, bytes_.size()));
    text_.erase(0, begin_);
    begin_ = 0;
    if (count == 0) {
        return false;
    }
    std::string chunk(static_cast<std::size_t>(count), '\0');
    bytes_.read(offset_, chunk);
    offset_ += count;
    if (encoding_ == Encoding::Bytes) {
        text_ += chunk;
        return true;
    }
    const auto order = encoding_ == Encoding::Utf16Little ? std::endian::little : std::endian::big;
    if (chunk.size() > 2 && endsInsidePair(chunk, order) && offset_ < bytes_.size()) {
        chunk.resize(chunk.size() - 2);
        offset_ -= 2;
    }
    text_ += utf16ToUtf8(chunk, order);
    return true;
}

void TextLines::fail(const std::string& what) const {
    throw InputError(bytes_.name(), "line " + std::to_string(number_), what);
}

}  // namespace asperity
