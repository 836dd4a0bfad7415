#include "app/session/FilmOfRecording.h"

#include "app/exports/ExportInput.h"
#include "app/exports/VideoFile.h"
#include "app/session/WindowArtist.h"

#include <memory>

namespace asperity {

namespace {

template <class Value>
ExportOption optionOf(Value value) {
    QString name = QString::fromUtf8(nameOf(value));
    name[0] = name.at(0).toUpper();
    return {.name = name, .key = QString::fromLatin1(keyOf(value))};
}

}  // namespace

std::vector<ExportOption> filmViews() {
    std::vector<ExportOption> options;
    for (const ExportView view : kValues<ExportView>) {
        if (isSpatial(view)) {
            options.push_back(optionOf(view));
        }
    }
    return options;
}

std::vector<ExportOption> filmMoments() {
    return {optionOf(NamedMoment::Start), optionOf(NamedMoment::SnapIn),
            optionOf(NamedMoment::Deepest), optionOf(NamedMoment::PullOff),
            optionOf(NamedMoment::End)};
}

FilmRequest filmRequest(const FilmChoices& choices, const PictureSpec& spec) {
    const auto view = fromKey<ExportView>(choices.view.toStdString());
    return {.view = view && isSpatial(*view) ? *view : ExportView::Spatial,
            .from = runMoment(choices.from.toStdString()),
            .to = runMoment(choices.to.toStdString()),
            .fps = static_cast<double>(choices.fps),
            .speed = choices.speed,
            .spec = spec};
}

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
    const FilmWork film{*input->run(), artist, ticks};
    isVideo(out) ? writeVideo(film, request, out, &drawing)
                 : writeFrames(film, request, out, kMayReplace, &drawing);
}

}  // namespace asperity
