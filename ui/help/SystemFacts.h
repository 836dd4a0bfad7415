#pragma once

#include <QStringList>

namespace asperity {

class PixelView;

/// What a bug report says of the machine, a line each: system, processor, screens, OpenGL.
/// @param view that draws with OpenGL; it may not have begun to
[[nodiscard]] QStringList systemFacts(const PixelView& view);

}  // namespace asperity
