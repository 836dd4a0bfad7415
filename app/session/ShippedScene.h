#pragma once

namespace asperity {

class Session;

/// A window without a scene would show settings of nothing: where the first file is not opened
/// after all, the scene that comes with the program is. Until a scene is shown.
/// @param isRecorded the first file was to be recorded: the program ends instead
void showShippedInstead(Session& session, bool isRecorded);

}  // namespace asperity
