#pragma once

#include "core/io/ByteReader.h"

#include <bit>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// The lines of a text, one after the other, without the whole text in memory. They may end with
/// LF, CR LF or CR; the text may be UTF-16 or UTF-8 with a byte order mark, and is any other
/// encoding of single bytes else.
class TextLines {
public:
    /// @param bytes must outlive this
    explicit TextLines(const ByteSource& bytes);

    /// The next line without its end, in UTF-8 where there is a byte order mark, else as it is
    /// stored; it holds until the next call. Empty at the end of the text.
    /// @throw InputError when a line has more than 8 MiB
    [[nodiscard]] std::optional<std::string_view> next();
    /// Returns the number of the last line; the first is 1.
    [[nodiscard]] long long number() const { return number_; }
    /// @throw InputError naming the file and the last line, always
    [[noreturn]] void fail(const std::string& what) const;

private:
    enum class Encoding { Bytes, Utf16Little, Utf16Big };

    /// Reads more of the text behind what is not given out yet. @return whether there was any
    bool readMore();
    /// The line that ends at this offset of the text in memory.
    std::string_view take(std::size_t end, std::size_t next);

    const ByteSource& bytes_;
    Encoding encoding_ = Encoding::Bytes;
    char lineEnd_ = '\n';
    std::uint64_t offset_ = 0;  ///< of the first byte that was not read yet
    std::string text_;
    std::size_t begin_ = 0;  ///< of the next line in the text
    long long number_ = 0;
};

}  // namespace asperity
