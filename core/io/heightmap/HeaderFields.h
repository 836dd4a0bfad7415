#pragma once

#include "core/io/ByteReader.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Limits of the texts that one image may carry.
struct TextQuota {
    /// Files of instruments have up to 1000 an image.
    std::size_t count = std::size_t{1} << 14U;
    std::size_t bytes = std::size_t{1} << 20U;  ///< of names and texts

    /// All images of a file together may carry this many quotas: enough for 512 images with 1000
    /// texts, 40 kB, each.
    static constexpr std::size_t kFullShares = 32;
    /// Returns the quota of each image where a file has this many of them.
    [[nodiscard]] static TextQuota ofEach(std::size_t images);
};

/// Limits of a header's texts while a reader looks for scale and other values in them. No image
/// carries this many.
inline constexpr TextQuota kHeaderQuota{.count = std::size_t{1} << 18U,
                                        .bytes = std::size_t{1} << 22U};

/// Texts of a file by their names, as many as an image may carry: a small file can hold many
/// short ones that they need many times its size of memory. What is beyond is left out.
class BoundedTexts {
public:
    BoundedTexts() = default;
    explicit BoundedTexts(const TextQuota& quota) : quota_(quota) {}

    /// Adds a text; of several with the same name the first one counts.
    void add(std::string name, std::string text);
    /// Adds a text; of several with the same name the last one that is not left out counts.
    void set(std::string name, std::string text);
    void remove(const std::string& name);
    /// Adds all of these.
    void add(const std::map<std::string, std::string>& texts);
    /// Adds texts; it is cut where these are.
    void add(const BoundedTexts& texts);

    [[nodiscard]] const std::map<std::string, std::string>& all() const { return texts_; }
    /// Returns whether texts were left out.
    [[nodiscard]] bool isCut() const { return isCut_; }

private:
    TextQuota quota_;
    std::map<std::string, std::string> texts_;
    std::size_t bytes_ = 0;
    bool isCut_ = false;
};

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
    /// @param location of this part in the file, for messages; empty: the header as a whole
    HeaderFields(std::string file, std::string location);

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
    [[nodiscard]] const std::string& location() const { return location_; }
    /// @throw InputError that names the field
    [[noreturn]] void fail(const std::string& key, const std::string& what) const;

private:
    std::string file_;
    std::string location_;
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
