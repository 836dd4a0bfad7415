#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// Type of a file by `gwyddion --identify`.
struct Identification {
    std::string name;    ///< for people: "Nearly raw raster data (NRRD) files (.nrrd)"
    std::string module;  ///< "nrrdfile"
    int score = 0;       ///< 100: certain

    /// Returns whether the format decides, and not a guess by size or file name.
    [[nodiscard]] bool isCertain() const { return score >= 50; }
    /// Returns whether it is a picture of at most 8 bits a color, whose values are no heights.
    [[nodiscard]] bool isPicture() const;
};

/// @param output of the program: "FILE: NAME [MODULE, SCORE]" among its warnings
/// @return empty when it is unknown
[[nodiscard]] std::optional<Identification> identificationIn(std::string_view output,
                                                             std::string_view file);

/// The version in "Gwyddion 2.62 (2022-11-03)"; empty when there is none.
[[nodiscard]] std::string versionIn(std::string_view output);

}  // namespace asperity
