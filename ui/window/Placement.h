#pragma once

#include <QRect>
#include <QSize>

namespace asperity {

// Places on a screen; all lengths are in pixels of the desktop, frames of windows are not included.

/// Where a window opens: in the middle of the screen, with room for its frame.
/// @param available of the screen, without task bars
[[nodiscard]] QRect openingPlace(const QSize& wanted, const QRect& available);

/// Where another window opens: right of `window`, else left of it, else over its right edge; on the
/// screen in any case.
[[nodiscard]] QRect placeBeside(const QRect& window, const QSize& wanted, const QRect& available);

}  // namespace asperity
