#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// One parameter of a NanoScope header.
struct NanoscopeEntry {
    std::string key;    ///< as written, without the backslash
    std::string value;  ///< UTF-8, trimmed
};

/// A "\*Name" section of a NanoScope header.
struct NanoscopeSection {
    std::string name;                               ///< "Ciao image list"
    std::map<std::string, NanoscopeEntry> entries;  ///< by key in lower case

    /// The value of a key, whatever its case; null when there is none.
    [[nodiscard]] const std::string* find(std::string_view key) const;
};

/// A value of the CIAO grammar: `V [soft scale] (hard scale) number unit` or
/// `S [internal name] "name on the screen"`.
struct CiaoValue {
    std::string bracket;           ///< soft scale or internal name; may be empty
    std::string text;              ///< what follows the brackets, without quotes
    std::optional<double> number;  ///< at the start of the text; always finite
    std::string unit;              ///< what follows the number
};

/// @return empty when a bracket is not closed or the type letter is missing
[[nodiscard]] std::optional<CiaoValue> parseCiaoValue(std::string_view value);

/// No header is longer [bytes]; real ones have 40 to 80 kB.
constexpr std::size_t kMaxNanoscopeHeader = std::size_t{1} << 20U;

/// Where the header ends, in bytes: the samples cannot start before.
[[nodiscard]] std::size_t nanoscopeHeaderSize(std::string_view bytes);

/// Takes a line without its backslash: "*Name" begins a section, "key: value" belongs to the last.
void takeNanoscopeLine(std::string_view line, std::vector<NanoscopeSection>& sections);

/// Reads the sections up to the end of the header.
/// @throw InputError when the header has no end or its line ends were changed on the way
[[nodiscard]] std::vector<NanoscopeSection> readNanoscopeHeader(std::string_view bytes,
                                                                const std::string& file);

}  // namespace asperity
