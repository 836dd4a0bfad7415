#pragma once

namespace asperity {

class Session;

/// A window without a scene would show settings of nothing: where the first file is not opened
/// after all, the scene that comes with the program is. Until a scene is shown.
void showShippedInstead(Session& session);

}  // namespace asperity
