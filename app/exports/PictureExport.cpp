#include "app/exports/PictureExport.h"

#include "app/exports/CurveTables.h"
#include "app/exports/FieldFile.h"
#include "app/exports/MomentCaption.h"
#include "app/exports/PlotFile.h"
#include "app/reports/ContactView.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/surface/fit/CoarserSurface.h"
#include "core/words/SceneWords.h"
#include "vtkplugins/pictures/OffscreenPicture.h"

#include <algorithm>
#include <vector>

namespace asperity {

namespace {

constexpr int kOverviewPixels = 1024;  // twice as many as the overview draws

std::string timeText(double time) { return formatted("t = %.3f s", time); }

/// Of a picture with a panel around its scene.
PictureLook panelLook(const PictureSpec& spec) {
    constexpr double kLeastWidth = 640.0;  // in pixels of letters
    constexpr double kLeastHeight = 480.0;
    return spec.look(kLeastWidth, kLeastHeight);
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
    OffscreenZoom zoom(input.scene(), spatialLook(request.view, request.spec));
    return zoom.draw(sample, isOfRun ? caption.of(sample) : std::string());
}

/// Where the tip went, no denser than it can be drawn.
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

}  // namespace asperity
