#pragma once

#include "ui/Theme.h"

#include <QString>

namespace asperity {

/// What the palette of Qt cannot say: borders, rounded corners, states of buttons.
[[nodiscard]] QString styleSheet(const ThemeColors& colors);

}  // namespace asperity
