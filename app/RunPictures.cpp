#include "app/RunPictures.h"

#include "core/SiFormat.h"
#include "core/io/PatchExr.h"
#include "core/scene/ContactPatch.h"
#include "core/surface/CoarserSurface.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace asperity {

namespace {

constexpr int kPatchSamples = 241;
constexpr int kOverviewPixels = 1024;  // twice as many as the overview draws

/// Half the width of the zoomed view: the surface that visibly follows the tip.
double zoomHalfWidth(const Scene& scene, const TickSample& sample) {
    const double given = scene.description.zoomHalfWidth;
    if (given > 0.0) {
        return given;
    }
    return std::max(scene.belief.tipRadius(), 4.0 * sample.output.model.contact.contactRadius);
}

PatchGrid gridAt(const Scene& scene, const TickSample& sample) {
    return {.halfWidth = zoomHalfWidth(scene, sample), .samples = kPatchSamples};
}

std::string timeText(double time) {
    char text[40];
    std::snprintf(text, sizeof text, "t = %.3f s", time);
    return text;
}

std::string captionOf(const Scene& scene, const TickSample& sample) {
    const TickOutput& out = sample.output;
    const ContactState& contact = out.model.contact;
    std::string caption = "Indentation " + formatSi(contact.indentation, "m") +
                          ", contact radius " + formatSi(contact.contactRadius, "m") +
                          ", normal force " + formatSi(contact.force, "N") + " (model), " +
                          formatSi(out.estimate.force.dot(out.model.foot.normal), "N") +
                          " (estimate). Tip of " + formatSi(scene.belief.tipRadius(), "m") +
                          " on " + scene.description.sample.material.name + ".";
    std::replace(caption.begin(), caption.end(), '_', ' ');
    if (out.flags.has(Validity::LargeContact)) {
        caption += " Contact radius above 0.3 tip radii: beyond what half-space theory holds for.";
    }
    if (out.flags.bits() != 0) {
        caption += " Flags: " + validityText(out.flags) + ".";
    }
    return caption;
}

/// The surface as it is drawn, and what there is to say of it.
struct DrawnSurface {
    SurfacePatch patch;
    std::string remark;
};

DrawnSurface drawnSurface(const Scene& scene, const TickSample& sample) {
    const TipState& state = sample.output.model;
    const DeformationTier tier = scene.description.deformation;
    const PatchGrid grid = gridAt(scene, sample);
    if (tier != DeformationTier::HalfSpace) {
        return {.patch = drawnPatch(scene, state, tier, grid), .remark = ""};
    }
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    return {.patch = answer.valid() ? halfSpacePatch(scene, answer, grid)
                                    : drawnPatch(scene, state, DeformationTier::ClosedForm, grid),
            .remark = " The " + sentenceOf(answer) + "."};
}

DeformationView viewOf(const Scene& scene, const TickSample& sample, const char* what) {
    const TickOutput& out = sample.output;
    DrawnSurface surface = drawnSurface(scene, sample);
    return {.title = std::string(what) + ", " + timeText(sample.time),
            .caption = captionOf(scene, sample) + surface.remark,
            .patch = std::move(surface.patch),
            .tipCentre = out.model.tip + Vector3(0.0, 0.0, scene.belief.tipRadius()),
            .tipRadius = scene.belief.tipRadius(),
            .tipDisplacement = tipDisplacement(scene, out.model, scene.description.deformation),
            .contactPoint = displacedFoot(scene, out.model, scene.description.deformation),
            .force = out.estimate.force,
            .contactRadius = out.model.contact.contactRadius};
}

std::vector<DeformationView> deformationViews(const Scene& scene, const RunEvents& events) {
    std::vector<DeformationView> views;
    views.push_back(viewOf(scene, *events.deepest, "Largest indentation"));
    if (events.beforePullOff) {
        views.push_back(viewOf(scene, *events.beforePullOff, "Just before pull-off"));
    }
    return views;
}

/// Where the zoomed view is at this moment.
ScanWindow zoomAt(const Scene& scene, const TickSample& moment) {
    const Vector3& tip = moment.output.model.tip;
    const double half = zoomHalfWidth(scene, moment);
    return {tip.x() - half, tip.x() + half, tip.y() - half, tip.y() + half};
}

}  // namespace

RunPictures::RunPictures(const Scene& scene, const RunEvents& events)
    : name_(sampleName(scene.description.sample))
    , deepest_(*events.deepest)
    , deformation_(deformationViews(scene, events))
    , deepestPatch_(contactPatch(scene, deepest_.output.model, scene.description.deformation,
                                 gridAt(scene, deepest_)))
    , surface_(coarserSurface(scene.surface, kOverviewPixels))
    , zoom_(zoomAt(scene, deepest_)) {}

void RunPictures::write(const std::filesystem::path& folder, const RunCurves& curves) const {
    writeDeformationPicture(folder / "deformation.png", deformation_);
    writePatchExr(folder / "deformation.exr", deepestPatch_);
    writeOverviewPicture(
        folder / "overview.png",
        {.title = name_,
         .caption = "The tip at the largest indentation, " + timeText(deepest_.time) + ".",
         .surface = surface_,
         .tip = deepest_.output.model.tip,
         .zoom = zoom_,
         .path = curves.tipPath()});
    curves.write(folder / "forces.png");
}

}  // namespace asperity
