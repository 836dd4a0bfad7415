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

/// What the comments before a matrix say: Gwyddion's export writes title, width, height and unit of
/// the values, in this order and in the user's language; all others become metadata.
void takeComments(const std::vector<TextComment>& comments, TextHeader& header);

}  // namespace asperity
