#pragma once

#include "app/exports/PictureFile.h"
#include "app/exports/RunMoment.h"
#include "app/recording/RunPlayback.h"

#include <filesystem>
#include <memory>
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

/// Draws the frames of a film, with one scale through all of them: all are foreseen first.
class FilmArtist {
public:
    virtual ~FilmArtist() = default;
    virtual void foresee(const TickSample& sample) = 0;
    /// All are foreseen.
    virtual void keepScales() = 0;
    /// @throw Error when drawing fails
    [[nodiscard]] virtual RasterImage draw(const TickSample& sample,
                                           const std::string& caption) = 0;
};

/// Draws on the thread that calls. There is an X display. The scene outlives it.
[[nodiscard]] std::unique_ptr<FilmArtist> filmArtist(const Scene& scene,
                                                     const OffscreenZoomLook& look);

/// Returns the look of a film: of one color throughout, that of a contact if none is chosen.
[[nodiscard]] OffscreenZoomLook filmLook(const FilmRequest& request);

/// Returns the ticks that the frames of a film show.
/// @throw Error where the part is empty, or has too many frames; Canceled
[[nodiscard]] std::vector<std::size_t> filmTicks(RunPlayback& run, const FilmRequest& request,
                                                 Progress* progress = nullptr);

/// Content of a film, and the artist that draws it.
struct FilmWork {
    RunPlayback& run;
    FilmArtist& artist;
    const std::vector<std::size_t>& ticks;  ///< of the frames
};

/// "frame_00001.png": of the first one, from 1.
[[nodiscard]] std::string frameName(std::size_t frame);

/// Draws the frames as PNG into a folder, and frames.csv with what each shows. Earlier frames in it
/// go. All or nothing.
/// @param force earlier frames may be deleted
/// @throw Error; Canceled
void writeFrames(const FilmWork& film, const FilmRequest& request,
                 const std::filesystem::path& folder, bool force, Progress* progress = nullptr);

/// Draws the frames into a video, .mp4 or .webm. Whole or not at all.
/// @throw Error, also where there is no ffmpeg; Canceled
void writeVideo(const FilmWork& film, const FilmRequest& request, const std::filesystem::path& path,
                Progress* progress = nullptr);

}  // namespace asperity
