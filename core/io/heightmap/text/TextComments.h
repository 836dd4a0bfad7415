#pragma once

#include "core/io/heightmap/text/TextHeader.h"

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// "# Width: 10.00 µm"
struct TextComment {
    std::string key;    ///< "Width"
    std::string value;  ///< "10.00 µm"
    long long line = 0;
};

/// Comments of our own files; lengths.
inline constexpr std::string_view kOriginXComment = "X offset";
inline constexpr std::string_view kOriginYComment = "Y offset";

/// What the comments before a matrix say: Gwyddion's export writes title, width, height and unit of
/// the values, in this order and in the user's language; ours have the origin after them. All
/// others become metadata.
void takeComments(const std::vector<TextComment>& comments, TextHeader& header);

/// A text with a decimal point in place of a decimal comma: "10,00 µm". Three digits behind a comma
/// may be thousands.
[[nodiscard]] std::string withDecimalPoint(std::string text);

/// Whether comments of the form "key = value", the keys in lower case, are those of SPIP.
[[nodiscard]] bool isSpip(const std::vector<TextComment>& assignments);
/// Takes size, origin and unit from them.
/// @param lines where they stand, for messages
/// @throw InputError when a number is none
void takeSpip(const std::vector<TextComment>& assignments, const TextLines& lines,
              TextHeader& header);

/// Whether they give the size of a matrix.
[[nodiscard]] bool giveSize(const std::vector<TextComment>& comments);

}  // namespace asperity
