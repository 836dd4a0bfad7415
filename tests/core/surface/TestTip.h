#pragma once

#include "core/Units.h"

namespace asperity::test {

/// The tip radius of most tests of surfaces [m].
inline constexpr double kTipRadius = 15.0_nm;

}  // namespace asperity::test
