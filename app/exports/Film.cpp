#include "app/exports/Film.h"

#include "app/exports/VideoFile.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>

namespace asperity {

namespace {

constexpr const char* kFrameTable = "frames.csv";

void requireSpatial(const FilmRequest& request) {
    if (!isSpatial(request.view)) {
        throw Error(std::string("a film shows a 3-D view, not ") + keyOf(request.view) +
                    ": 3d, front, back, right, left, top, bottom or section");
    }
}

using FrameSink = std::function<void(std::size_t frame, const TickSample&, const RasterImage&)>;

class OffscreenArtist : public FilmArtist {
public:
    OffscreenArtist(const Scene& scene, const OffscreenZoomLook& look) : zoom_(scene, look) {}

    void foresee(const TickSample& sample) override { zoom_.foresee(sample); }
    void keepScales() override { zoom_.keepScales(); }
    RasterImage draw(const TickSample& sample, const std::string& caption) override {
        return zoom_.draw(sample, caption);
    }

private:
    OffscreenZoom zoom_;
};

/// Draws all frames. First all are foreseen, undrawn.
void drawFrames(const FilmWork& film, const FrameSink& sink, Progress* progress) {
    constexpr double kForeseen = 0.15;  // of the work
    const auto& [run, artist, ticks] = film;
    MomentCaption caption;
    const double count = static_cast<double>(ticks.size());
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        reportTo(progress, kForeseen * static_cast<double>(i) / count);
        artist.foresee(run.at(ticks[i]));
        caption.take(run.at(ticks[i]));
    }
    artist.keepScales();
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        reportTo(progress, kForeseen + (1.0 - kForeseen) * static_cast<double>(i) / count);
        const TickSample& sample = run.at(ticks[i]);
        sink(i, sample, artist.draw(sample, caption.of(sample)));
    }
    reportTo(progress, 1.0);
}

bool isFrameName(const std::string& name) {
    static const std::regex pattern("frame_[0-9]{5}\\.png");
    return std::regex_match(name, pattern);
}

/// The files of a film, and all that an earlier one may have left.
FolderContent filmFiles(const std::filesystem::path& folder, std::size_t frames) {
    FolderContent content{.marks = {kFrameTable}, .own = {}, .guarded = {}};
    for (std::size_t i = 0; i < frames; ++i) {
        content.own.push_back(frameName(i));
    }
    std::error_code none;
    for (const auto& file : std::filesystem::directory_iterator(folder, none)) {
        const std::string name = file.path().filename().string();
        if (isFrameName(name) && std::ranges::find(content.own, name) == content.own.end()) {
            content.own.push_back(name);
        }
    }
    return content;
}

void requireFree(const std::filesystem::path& folder, const FolderContent& content, bool force) {
    for (const auto* names : {&content.marks, &content.own}) {
        for (const std::string& name : *names) {
            if (!force && isThere(folder / name)) {
                throw Error((folder / name).string() + ": there is a film in that folder; name "
                                                       "another one, or replace it with --force");
            }
        }
    }
}

}  // namespace

std::unique_ptr<FilmArtist> filmArtist(const Scene& scene, const OffscreenZoomLook& look) {
    return std::make_unique<OffscreenArtist>(scene, look);
}

OffscreenZoomLook filmLook(const FilmRequest& request) {
    OffscreenZoomLook look = spatialLook(request.view, request.spec);
    look.color = request.spec.color.value_or(contactColor());
    return look;
}

std::string frameName(std::size_t frame) { return formatted("frame_%05zu.png", frame + 1); }

std::vector<std::size_t> filmTicks(RunPlayback& run, const FilmRequest& request,
                                   Progress* progress) {
    requireSpatial(request);
    ProgressPart first(progress, 0.0, 0.5);
    const double from = run.time(tickOf(run, request.from, &first));
    ProgressPart second(progress, 0.5, 1.0);
    const double to = run.time(tickOf(run, request.to, &second));
    if (!(from < to)) {
        throw Error(formatted("a film from %.6g s to %.6g s has no length", from, to));
    }
    const double duration = request.duration.value_or((to - from) / request.speed);
    const double frames = std::max(1.0, std::round(duration * request.fps));
    if (!(frames <= static_cast<double>(kMaxFilmFrames))) {
        throw Error(
            formatted("a film of %.0f frames is too long: at most %zu", frames, kMaxFilmFrames));
    }
    std::vector<std::size_t> ticks;
    for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
        const double share = frames > 1.0 ? static_cast<double>(i) / (frames - 1.0) : 0.0;
        ticks.push_back(run.tickAt(std::lerp(from, to, share)));
    }
    return ticks;
}

void writeFrames(const FilmWork& film, const FilmRequest& request,
                 const std::filesystem::path& folder, bool force, Progress* progress) {
    const FolderContent content = filmFiles(folder, film.ticks.size());
    requireFree(folder, content, force);
    constexpr bool kMayReplace = true;  // what there is was asked for above
    OutputFolder out(folder, content, kMayReplace);
    out.collect([&](const std::filesystem::path& staging) {
        CsvWriter table(staging / kFrameTable,
                        {std::string("Asperity ") + kVersion + ": frames of a film",
                         "normal force on the tip, estimated; indentation < 0: a gap"},
                        {"frame", "time_s", "normal_force_n", "indentation_m", "state"});
        drawFrames(
            film,
            [&](std::size_t frame, const TickSample& sample, const RasterImage& image) {
                writePicture(staging / frameName(frame), image, ExportFormat::Png,
                             request.spec.dpi);
                const TickOutput& output = sample.output;
                table.add(frameName(frame))
                    .add(sample.time)
                    .add(output.estimate.force.dot(output.model.normal))
                    .add(output.model.contact.indentation)
                    .add(keyOf(output.model.contact.region()))
                    .endRow();
            },
            progress);
        table.close();
    });
    out.commit();
}

void writeVideo(const FilmWork& film, const FilmRequest& request, const std::filesystem::path& path,
                Progress* progress) {
    if (request.spec.transparent) {
        throw Error(path.string() + ": a video has no transparency; give a folder for pictures");
    }
    VideoFile video(path, request.spec.size, request.fps);
    drawFrames(
        film,
        [&](std::size_t, const TickSample&, const RasterImage& image) {
            video.add(image, progress);
        },
        progress);
    video.commit(progress);
}

}  // namespace asperity
