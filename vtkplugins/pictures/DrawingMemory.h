#pragma once

#include "vtkplugins/pictures/PictureSize.h"

namespace asperity {

/// Sees to it that OpenGL gets the memory that it takes: its drivers end the program with a
/// segmentation fault where an allocation fails. Checks what the system grants at once (ulimit -v)
/// and what it says is available now.
/// @param drawn all pixels that are drawn, those averaged away too
/// @throw Error when the system does not grant as much
void requireDrawingMemory(PictureSize drawn);

}  // namespace asperity
