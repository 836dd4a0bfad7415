#pragma once

#include "app/exports/Film.h"
#include "app/session/PiecesHere.h"
#include "ui/window/ExportChoices.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// Views that a film can show, as a dialog offers them.
[[nodiscard]] std::vector<ExportOption> filmViews();
/// Moments between which it can go, by the time at which they come.
[[nodiscard]] std::vector<ExportOption> filmMoments();

/// What was chosen. @throw Error where a moment is none
[[nodiscard]] FilmRequest filmRequest(const FilmChoices& choices, const PictureSpec& spec);

/// Makes a film of a recording in the background: a video, or else a folder of pictures, in place
/// of an earlier film. Frames are drawn by the window's thread, one at a time.
/// @param recording folder of a run, or a bundle
/// @throw Error; InputError; Canceled
void filmRecording(const std::filesystem::path& recording, const FilmRequest& request,
                   const std::filesystem::path& out, PiecesHere& pieces, Progress& progress);

}  // namespace asperity
