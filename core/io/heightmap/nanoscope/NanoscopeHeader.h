#pragma once

#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
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
    std::string hardScale;         ///< "0.000375 V/LSB"; may be empty
    std::string text;              ///< after the brackets, without quotes
    std::optional<double> number;  ///< at the start of the text; always finite
    std::string unit;              ///< after the number
};

/// @return empty when a bracket is not closed or the type letter is missing
[[nodiscard]] std::optional<CiaoValue> parseCiaoValue(std::string_view value);

/// No header is longer [bytes]; real ones have 40 to 80 kB.
constexpr std::size_t kMaxNanoscopeHeader = std::size_t{1} << 20U;

/// Returns the end of the header [bytes]: the samples cannot start before.
[[nodiscard]] std::size_t nanoscopeHeaderSize(std::string_view bytes);

/// Takes a line without its backslash: "*Name" begins a section, "key: value" belongs to the last.
void takeNanoscopeLine(std::string_view line, std::vector<NanoscopeSection>& sections);

/// Reads the sections up to the end of the header.
/// @throw InputError when the header has no end or its line ends were changed by a transfer
[[nodiscard]] std::vector<NanoscopeSection> readNanoscopeHeader(std::string_view bytes,
                                                                const std::string& file);

/// Returns the front of a file with its whole header, where it has one.
[[nodiscard]] std::string nanoscopeStart(const ByteSource& bytes);

/// Returns an entry, whatever section it is in: the first one counts; null: there is none.
[[nodiscard]] const std::string* nanoscopeEntry(const std::vector<NanoscopeSection>& sections,
                                                std::string_view key);

/// Returns the bytes of a sample by the header's version, whatever "Bytes/pixel" says.
[[nodiscard]] int nanoscopeSampleBytes(std::string_view version);

// Names of the sections of a NanoScope header, in lower case. NanoScope E and others have other
// names for the same lists. Source: docs/formats.md 3.

inline constexpr std::array<std::string_view, 3> kNanoscopeFileLists{"file list", "ec file list",
                                                                     "force file list"};
inline constexpr std::array<std::string_view, 2> kNanoscopeScannerLists{"scanner list",
                                                                        "microscope list"};
inline constexpr std::array<std::string_view, 4> kNanoscopeScanLists{"ciao scan list", "afm list",
                                                                     "stm list", "nc afm list"};
/// Lists that give the grid of the scan.
inline constexpr std::array<std::string_view, 5> kNanoscopeGridLists{
    "ciao scan list", "afm list", "stm list", "nc afm list", "ciao force list"};
inline constexpr std::array<std::string_view, 1> kNanoscopeControllerLists{"controller list"};
inline constexpr std::array<std::string_view, 5> kNanoscopeImageLists{
    "ciao image list", "afm image list", "stm image list", "ncafm image list", "image list"};

[[nodiscard]] inline bool isNamed(const NanoscopeSection& section,
                                  std::span<const std::string_view> names) {
    return std::ranges::count(names, lowerCase(section.name)) > 0;
}

/// Returns whether a section lists an image.
[[nodiscard]] inline bool isNanoscopeImageList(const NanoscopeSection& section) {
    return isNamed(section, kNanoscopeImageLists);
}

}  // namespace asperity
