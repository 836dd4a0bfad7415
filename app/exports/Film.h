#pragma once

#include "app/exports/ExportInput.h"
#include "app/exports/RunMoment.h"
#include "app/exports/SpatialLook.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A film of a run, or of a part of it.
struct FilmRequest {
    ExportView view = ExportView::Spatial;  ///< a 3-D one
    RunMoment from = NamedMoment::Start;
    RunMoment to = NamedMoment::End;
    double fps = 25.0;                    ///< frames a second
    double speed = 1.0;                   ///< seconds of the run per second of the film
    std::optional<double> duration = {};  ///< of the film, picks the speed [s]
    PictureSpec spec;
};

inline constexpr std::size_t kMaxFilmFrames = 99'999;

/// Which ticks the frames of a film show.
/// @throw Error where the part is empty, or has too many frames; Canceled
[[nodiscard]] std::vector<std::size_t> filmTicks(RunPlayback& run, const FilmRequest& request,
                                                 Progress* progress = nullptr);

/// "frame_00001.png": of the first one, from 1.
[[nodiscard]] std::string frameName(std::size_t frame);

/// Draws the frames as PNG into a folder, and frames.csv with what each shows. Earlier frames in it
/// go. All or nothing. There is an X display.
/// @param force earlier frames may go
/// @throw Error; Canceled
void writeFrames(ExportInput& input, const FilmRequest& request,
                 const std::vector<std::size_t>& ticks, const std::filesystem::path& folder,
                 bool force, Progress* progress = nullptr);

/// Draws the frames into a video, .mp4 or .webm. Whole or not at all. There is an X display.
/// @throw Error, also where there is no ffmpeg; Canceled
void writeVideo(ExportInput& input, const FilmRequest& request,
                const std::vector<std::size_t>& ticks, const std::filesystem::path& path,
                Progress* progress = nullptr);

}  // namespace asperity
