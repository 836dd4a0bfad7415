#pragma once

#include "core/io/ByteSource.h"
#include "core/io/heightmap/BoundedTexts.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A text at the front of a file, before its samples.
struct HeaderText {
    std::string text;       ///< without the mark that ends it
    std::uint64_t end = 0;  ///< first byte after that mark
};

/// @throw InputError when the mark is not within the first 256 KiB; real headers have 2 to 40 KiB
[[nodiscard]] HeaderText headerText(const ByteSource& bytes, std::string_view mark);

/// The lines of a text, which end with CR, LF or both, without these.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

/// The fields of one part of a header.
class HeaderFields {
public:
    /// @param file  for messages
    /// @param place of this part in the file, for messages; empty: the header as a whole
    HeaderFields(std::string file, std::string place);

    /// Adds a field, trimmed and as UTF-8; of several with the same key the first one counts.
    void add(std::string_view key, std::string_view value);

    /// Null when there is no such field.
    [[nodiscard]] const std::string* find(const std::string& key) const&;
    [[nodiscard]] const std::string*
    find(const std::string& key) const&& = delete;  ///< it would not last
    /// Empty when there is no such field.
    [[nodiscard]] std::string text(const std::string& key) const;
    /// @throw InputError when there is no such field
    [[nodiscard]] const std::string& required(const std::string& key) const&;
    [[nodiscard]] const std::string&
    required(const std::string& key) const&& = delete;  ///< it would not last
    /// @throw InputError when the field is missing or no whole number
    [[nodiscard]] long long integer(const std::string& key) const;
    /// Empty when the field is missing or empty. @throw InputError when it is no number
    [[nodiscard]] std::optional<double> number(const std::string& key) const;
    /// @throw InputError when the field is missing or no number
    [[nodiscard]] double requiredNumber(const std::string& key) const;
    [[nodiscard]] const std::map<std::string, std::string>& all() const { return fields_.all(); }
    [[nodiscard]] const BoundedTexts& texts() const { return fields_; }
    [[nodiscard]] const std::string& place() const { return place_; }
    /// @throw InputError that names the field
    [[noreturn]] void fail(const std::string& key, const std::string& what) const;

private:
    std::string file_;
    std::string place_;
    BoundedTexts fields_{kHeaderQuota};
};

/// The parts of a header by their names; lines `[name]` begin one.
using HeaderSections = std::map<std::string, HeaderFields>;

/// @param separator between key and value: the first one of a line; lines without it are left out
[[nodiscard]] HeaderSections sectionsOf(std::string_view text, char separator,
                                        const std::string& file);

/// A number with a unit of length, "-712.919 nm" [m]; empty when it is anything else.
[[nodiscard]] std::optional<double> parseLength(std::string_view text);

}  // namespace asperity
