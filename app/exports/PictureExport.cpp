#include "app/exports/PictureExport.h"

#include "app/exports/CurveTables.h"
#include "app/exports/SurfaceFile.h"
#include "app/reports/RunPictures.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/words/SceneWords.h"
#include "vtkplugins/pictures/OffscreenPicture.h"

#include <algorithm>
#include <vector>

namespace asperity {

namespace {

constexpr int kOverviewPixels = 1024;  // twice as many as the overview draws

std::string timeText(double time) { return formatted("t = %.3f s", time); }

/// Returns the look of a picture with a panel around its scene.
PictureLook panelLook(const PictureSpec& spec) {
    constexpr double kMinWidth = 640.0;  // in pixels of letters
    constexpr double kMinHeight = 480.0;
    return spec.look(kMinWidth, kMinHeight);
}

std::string titleOf(const PictureRequest& request, const TickSample& sample) {
    const auto* const named = std::get_if<NamedMoment>(&request.moment);
    return named == nullptr ? timeText(sample.time)
                            : nameOf(*named) + (", " + timeText(sample.time));
}

RasterImage spatialImage(const ExportInput& input, const PictureRequest& request,
                         const TickSample& sample, bool isOfRun) {
    MomentCaption caption;
    caption.take(sample);
    OffscreenZoomLook look = spatialLook(request.view, request.spec);
    if (!look.color && sample.output.region() == TipRegion::Contact) {
        look.color = contactColor();
    }
    OffscreenZoom zoom(input.scene(), look);
    return zoom.draw(sample, isOfRun ? caption.of(sample) : std::string());
}

/// Returns the path of the tip, no denser than it can be drawn.
std::vector<Vector3> pathOf(RunPlayback& run, double size, Progress* progress) {
    constexpr double kSeen = 1.0 / 4000.0;
    std::vector<Vector3> path;
    run.play(
        0,
        [&](const TickSample& sample) {
            const Vector3& tip = sample.output.tip;
            if (path.empty() || (tip - path.back()).norm() > kSeen * size) {
                path.push_back(tip);
            }
            return true;
        },
        progress);
    return path;
}

RasterImage overviewImage(ExportInput& input, const PictureRequest& request,
                          const TickSample& sample, Progress* progress) {
    const Scene& scene = input.scene();
    const BSplineSurface surface = coarserSurface(scene.surface, kOverviewPixels);
    const bool isOfRun = input.run() != nullptr;
    const OverviewView view{
        .title = sampleName(scene.description.sample),
        .caption = isOfRun ? "The tip at " + timeText(sample.time) + "."
                           : "The tip where the window starts with it.",
        .surface = surface,
        .tip = sample.output.model.tip,
        .zoom = {},
        .path = isOfRun ? pathOf(*input.run(), std::max(surface.sizeX(), surface.sizeY()), progress)
                        : std::vector<Vector3>(),
        .heightScale = request.spec.heightScale};
    OffscreenPicture picture(request.spec.size, panelLook(request.spec));
    drawOverview(picture, view, request.spec.parts);
    return picture.image();
}

PatchGrid gridOf(const ExportInput& input, const PictureRequest& request,
                 const TickSample& sample) {
    PatchGrid grid = zoomGrid(input.scene(), sample);
    if (request.spec.width) {
        grid.halfWidth = 0.5 * *request.spec.width;
    }
    return grid;
}

RasterImage deformationImage(const ExportInput& input, const PictureRequest& request,
                             const TickSample& sample) {
    std::vector<DeformationView> views{contactView(input.scene(), sample, titleOf(request, sample),
                                                   gridOf(input, request, sample))};
    views.front().heightScale = request.spec.heightScale;
    OffscreenPicture picture(request.spec.size, panelLook(request.spec));
    drawDeformation(picture, views, request.spec.parts);
    return picture.image();
}

void writePlot(RunPlayback& run, const PictureRequest& request, const std::filesystem::path& path,
               ExportFormat format, Progress* progress) {
    if (request.view == ExportView::Forces) {
        format == ExportFormat::Csv
            ? writeForcesTable(path, run, progress)
            : writePlotPage(path, forceCharts(run, progress), request.spec, format);
        return;
    }
    ProgressPart finding(progress, 0.0, 0.5);
    const std::size_t tick = tickOf(run, request.moment, &finding);
    ProgressPart playing(progress, 0.5, 1.0);
    const std::vector<CyclePoint> cycle = cycleAround(run, tick, &playing);
    format == ExportFormat::Csv
        ? writeCycleTable(path, cycle)
        : writePlotPage(path, {{cycleChart(cycle, run.at(tick))}}, request.spec, format);
}

constexpr const char* kUsualName = "{file}_{view}_{n}.png";

/// @throw Error for a placeholder that there is not
std::string filled(const std::string& text, const OutputNameParts& parts, int number) {
    std::string name;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] != '{') {
            name += text[at++];
            continue;
        }
        const std::size_t end = text.find('}', at);
        const std::string placeholder =
            text.substr(at, end == std::string::npos ? end : end - at + 1);
        if (placeholder == "{file}") {
            name += parts.file;
        } else if (placeholder == "{view}") {
            name += parts.view;
        } else if (placeholder == "{n}") {
            name += std::to_string(number);
        } else {
            throw Error("'" + placeholder +
                        "' is no placeholder of a name: expected {file}, {view} or {n}");
        }
        at += placeholder.size();
    }
    return name;
}

}  // namespace

void requireDrawable(const PictureRequest& request, bool hasRun) {
    const std::string view = keyOf(request.view);
    if (needsRun(request.view) && !hasRun) {
        throw Error("the view " + view +
                    " needs a run: give the folder that explore or a recording wrote");
    }
    if (request.spec.width && !isSpatial(request.view) && request.view != ExportView::Deformation) {
        throw Error("the view " + view + " has no frame whose width can be chosen (--width)");
    }
    if (request.spec.color && !isSpatial(request.view)) {
        throw Error("the view " + view + " has no surface whose color can be chosen (--color)");
    }
    if (request.spec.heightScale && isPlot(request.view)) {
        throw Error("the view " + view + " has no heights that can be scaled (--height-scale)");
    }
}

void writeExport(ExportInput& input, const PictureRequest& request,
                 const std::filesystem::path& path, ExportFormat format, Progress* progress) {
    requireDrawable(request, input.run() != nullptr);
    if (isPlot(request.view)) {
        writePlot(*input.run(), request, path, format, progress);
        return;
    }
    ProgressPart finding(progress, 0.0, 0.5);
    const TickSample sample = input.run() == nullptr
                                  ? input.restingSample()
                                  : input.run()->at(tickOf(*input.run(), request.moment, &finding));
    ProgressPart drawing(progress, 0.5, 1.0);
    if (!isRaster(format)) {
        writeField(path, zoomPatch(input.scene(), sample, gridOf(input, request, sample)), format);
        return;
    }
    const RasterImage image = request.view == ExportView::Overview
                                  ? overviewImage(input, request, sample, &drawing)
                              : request.view == ExportView::Deformation
                                  ? deformationImage(input, request, sample)
                                  : spatialImage(input, request, sample, input.run() != nullptr);
    writePicture(path, image, format, request.spec.dpi);
}

std::filesystem::path namedPath(const std::filesystem::path& folder, const std::string& name,
                                const OutputNameParts& parts) {
    const bool counts = name.find("{n}") != std::string::npos;
    for (int number = 1;; ++number) {
        std::filesystem::path path = folder / filled(name, parts, number);
        if (!counts || !isThere(path)) {
            return path;
        }
    }
}

std::filesystem::path filledPath(const std::filesystem::path& out, const OutputNameParts& parts) {
    return namedPath(out.parent_path(), out.filename().string(), parts);
}

std::filesystem::path outputPath(const std::string& out, const OutputNameParts& parts, bool force) {
    std::error_code unknown;
    const bool isFolder = out.ends_with('/') || std::filesystem::is_directory(out, unknown);
    std::filesystem::path path =
        isFolder ? namedPath(out, kUsualName, parts) : filledPath(out, parts);
    requireFree(path, force);
    return path;
}

}  // namespace asperity
