#pragma once

namespace asperity {

/// Keeps VTK from writing to the terminal: what fails there is an Error here, told once and with
/// the file's name. Of all threads.
void silenceVtk();

}  // namespace asperity
