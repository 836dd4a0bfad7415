#include "app/session/FilmOfRecording.h"

#include "app/exports/ExportInput.h"
#include "app/exports/VideoFile.h"
#include "app/session/WindowArtist.h"

#include <memory>

namespace asperity {

void filmRecording(const std::filesystem::path& recording, const FilmRequest& request,
                   const std::filesystem::path& out, PiecesHere& pieces, Progress& progress) {
    ProgressPart loading(&progress, 0.0, 0.1);
    const auto input = std::make_shared<ExportInput>(recording, &loading);
    ProgressPart finding(&progress, 0.1, 0.15);
    const std::vector<std::size_t> ticks = filmTicks(*input->run(), request, &finding);
    ProgressPart drawing(&progress, 0.15, 1.0);
    WindowArtist artist(
        [input, look = spatialLook(request.view, request.spec)] {
            return filmArtist(input->scene(), look);
        },
        pieces, progress);
    constexpr bool kMayReplace = true;  // what there is was asked for before
    isVideo(out) ? writeVideo(*input->run(), artist, request, ticks, out, &drawing)
                 : writeFrames(*input->run(), artist, request, ticks, out, kMayReplace, &drawing);
}

}  // namespace asperity
