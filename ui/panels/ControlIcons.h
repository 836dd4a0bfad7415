#pragma once

#include <QIcon>

namespace asperity {

enum class ControlIcon { Start, Pause, PauseCurves, ForcesOn, ForcesOff, Record };

/// The signs on the control bar's buttons, drawn: no font is sure to have them.
[[nodiscard]] QIcon controlIcon(ControlIcon icon);

}  // namespace asperity
