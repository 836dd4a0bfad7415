#pragma once

#include "core/io/ByteReader.h"

#include <string>
#include <string_view>

namespace asperity {

/// Ends the refusal of a file that holds force curves and no image, where they are read.
inline constexpr std::string_view kCurvePointer =
    "; 'asperity info' lists them, 'asperity fit' evaluates them";

/// Returns the program whose force curves a content holds, which no reader of images accepts;
/// empty: it is of none.
[[nodiscard]] std::string forceCurveProgram(const ByteSource& bytes);

}  // namespace asperity
