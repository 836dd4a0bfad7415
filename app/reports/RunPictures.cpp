#include "app/reports/RunPictures.h"

#include "app/reports/ContactView.h"
#include "app/runs/RunFolder.h"
#include "core/FormattedText.h"
#include "core/io/fields/PatchExr.h"
#include "core/scene/Scene.h"
#include "core/surface/fit/CoarserSurface.h"
#include "core/words/SceneWords.h"

namespace asperity {

namespace {

constexpr int kOverviewPixels = 1024;  // twice as many as the overview draws

std::string timeText(double time) { return formatted("t = %.3f s", time); }

DeformationView viewOf(const Scene& scene, const TickSample& sample, const char* what) {
    return contactView(scene, sample, std::string(what) + ", " + timeText(sample.time));
}

bool isContact(const TickSample& sample) { return sample.output.region() == TipRegion::Contact; }

std::string captionOf(const TickSample& deepest) {
    return isContact(deepest)
               ? "The tip at the maximum indentation, " + timeText(deepest.time) + "."
               : "The tip nearest to the sample, " + timeText(deepest.time) +
                     ": the contact model has no contact.";
}

std::vector<DeformationView> deformationViews(const Scene& scene, const RunEvents& events) {
    std::vector<DeformationView> views;
    views.push_back(
        viewOf(scene, *events.deepest,
               isContact(*events.deepest) ? "Maximum indentation" : "Nearest to the sample"));
    if (events.lastHold) {
        views.push_back(viewOf(scene, *events.lastHold, "Just before pull-off"));
    }
    return views;
}

/// Where the zoomed view is at this moment.
ScanWindow zoomAt(const Scene& scene, const TickSample& moment) {
    const Vector3& tip = moment.output.model.tip;
    const double half = zoomGrid(scene, moment).halfWidth;
    return {tip.x() - half, tip.x() + half, tip.y() - half, tip.y() + half};
}

}  // namespace

RunPictures::RunPictures(const Scene& scene, const RunEvents& events)
    : name_(sampleName(scene.description.sample))
    , deepest_(*events.deepest)
    , deformation_(deformationViews(scene, events))
    , deepestPatch_(zoomPatch(scene, deepest_))
    , surface_(coarserSurface(scene.surface, kOverviewPixels))
    , zoom_(zoomAt(scene, deepest_)) {}

void RunPictures::write(const std::filesystem::path& folder, const RunCurves& curves,
                        Progress* progress) const {
    reportTo(progress, 0.0);
    writeDeformation(folder / run_files::kDeformation);
    reportTo(progress, 0.4);
    writePatchExr(folder / run_files::kDeformationFields, deepestPatch_);
    reportTo(progress, 0.5);
    writeOverview(folder / run_files::kOverview, curves.tipPath());
    reportTo(progress, 0.8);
    curves.write(folder / run_files::kForces);
    reportTo(progress, 1.0);
}

void RunPictures::writeDeformation(const std::filesystem::path& path, PictureSize size) const {
    writeDeformationPicture(path, deformation_, size);
}

void RunPictures::writeOverview(const std::filesystem::path& path,
                                const std::vector<Vector3>& tipPath, PictureSize size) const {
    writeOverviewPicture(path,
                         {.title = name_,
                          .caption = captionOf(deepest_),
                          .surface = surface_,
                          .tip = deepest_.output.model.tip,
                          .zoom = zoom_,
                          .path = tipPath},
                         size);
}

}  // namespace asperity
