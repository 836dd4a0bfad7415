#pragma once

namespace asperity {

/// Whether an X display answers; VTK ends the program when it draws without one. The connection
/// stays open: a bare X server (Xvfb) starts anew, and refuses clients meanwhile, whenever its last
/// one leaves.
[[nodiscard]] bool haveDisplay();

}  // namespace asperity
