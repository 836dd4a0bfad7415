#pragma once

#include "vtkplugins/pictures/PictureSize.h"

namespace asperity {

/// Sees to it that OpenGL gets the memory that it takes: its drivers end the program with a
/// segmentation fault where an allocation fails. Checks what the system grants at once (ulimit -v);
/// it cannot foresee the end of memory that is granted but not there.
/// @param drawn all pixels that are drawn, those averaged away too
/// @throw Error when the system does not grant as much
void requireDrawingMemory(PictureSize drawn);

}  // namespace asperity
