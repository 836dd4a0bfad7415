#pragma once

#include "core/FormattedText.h"
#include "vtkplugins/pictures/Color.h"

#include <string>

namespace asperity {

/// A color as style sheets have it.
[[nodiscard]] inline std::string styleColor(const Color& color) {
    return formatted("#%02x%02x%02x", color.red, color.green, color.blue);
}

}  // namespace asperity
