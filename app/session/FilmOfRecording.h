#pragma once

#include "app/exports/Film.h"
#include "app/session/PiecesHere.h"

#include <filesystem>

namespace asperity {

/// Makes a film of a recording in the background: a video, or else a folder of pictures, in place
/// of an earlier film. Frames are drawn by the window's thread, one at a time.
/// @param recording folder of a run, or a bundle
/// @throw Error; InputError; Canceled
void filmRecording(const std::filesystem::path& recording, const FilmRequest& request,
                   const std::filesystem::path& out, PiecesHere& pieces, Progress& progress);

}  // namespace asperity
