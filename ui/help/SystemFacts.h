#pragma once

#include <QStringList>

class QOpenGLWidget;

namespace asperity {

/// What a bug report says of the machine, a line each: system, processor, screens, OpenGL.
/// @param view that draws with OpenGL; it may not have begun to
[[nodiscard]] QStringList systemFacts(QOpenGLWidget& view);

}  // namespace asperity
