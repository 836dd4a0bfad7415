#pragma once

#include "vtkplugins/pictures/RasterImage.h"

namespace asperity {

/// Returns whether an X display answers; VTK ends the program when it draws without one. The
/// connection stays open: a bare X server (Xvfb) restarts, and refuses clients until then, whenever
/// its last one leaves.
[[nodiscard]] bool haveDisplay();

/// Keeps VTK from writing to the terminal: what fails there is an Error here, told once and with
/// the file's name. Of all threads.
void silenceVtk();

/// Sees to it that OpenGL gets the memory that it takes: its drivers end the program with a
/// segmentation fault where an allocation fails. Checks what the system grants at once (ulimit -v)
/// and what it says is available now.
/// @param drawn all pixels that are drawn, those averaged away too
/// @throw Error when the system does not grant as much
void requireDrawingMemory(PictureSize drawn);

}  // namespace asperity
