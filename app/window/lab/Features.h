#pragma once

#include <filesystem>

namespace asperity {

class Stage;

/// Adds all features of the window, in the order in which they are told of the run.
void addFeatures(Stage& stage);

/// Keeps the session in a folder from now on; its files are no recent ones of the user's.
void keepSession(Stage& stage, const std::filesystem::path& folder);

/// Shows the scene that comes with the program where the first file is not opened after all: a
/// window without a scene would show settings of nothing. Until a scene is shown.
void showShippedInstead(Stage& stage);

}  // namespace asperity
