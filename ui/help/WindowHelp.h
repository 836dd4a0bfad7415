#pragma once

#include "ui/help/CheatSheet.h"

class QMenuBar;

namespace asperity {

/// All that keys and mouse do in the window: its menus' keys, and what its parts say of themselves.
[[nodiscard]] std::vector<HelpSection> windowHelp(const QMenuBar& bar);

}  // namespace asperity
