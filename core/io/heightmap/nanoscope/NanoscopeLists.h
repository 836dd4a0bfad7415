#pragma once

#include "core/io/TextValue.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace asperity {

// Names of the sections of a NanoScope header, in lower case. NanoScope E and others have other
// names for the same lists. Source: docs/formats.md 3.

inline constexpr std::array<std::string_view, 3> kNanoscopeFileLists{"file list", "ec file list",
                                                                     "force file list"};
inline constexpr std::array<std::string_view, 2> kNanoscopeScannerLists{"scanner list",
                                                                        "microscope list"};
inline constexpr std::array<std::string_view, 4> kNanoscopeScanLists{"ciao scan list", "afm list",
                                                                     "stm list", "nc afm list"};
/// Those that give the grid of the scan.
inline constexpr std::array<std::string_view, 5> kNanoscopeGridLists{
    "ciao scan list", "afm list", "stm list", "nc afm list", "ciao force list"};
inline constexpr std::array<std::string_view, 1> kNanoscopeControllerLists{"controller list"};
inline constexpr std::array<std::string_view, 5> kNanoscopeImageLists{
    "ciao image list", "afm image list", "stm image list", "ncafm image list", "image list"};

[[nodiscard]] inline bool isNamed(const NanoscopeSection& section,
                                  std::span<const std::string_view> names) {
    return std::ranges::count(names, lowerCase(section.name)) > 0;
}

/// Whether a section lists an image.
[[nodiscard]] inline bool isNanoscopeImageList(const NanoscopeSection& section) {
    return isNamed(section, kNanoscopeImageLists);
}

}  // namespace asperity
