#include "app/reports/RunPictures.h"

#include "app/charts/ChartFile.h"
#include "app/runs/RunFolder.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/deformation/ContactDeformation.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/io/fields/PatchExr.h"
#include "core/scene/Scene.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/words/ModelWords.h"
#include "core/words/SceneWords.h"
#include "ui/view/ViewFrame.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// The component of every vector along one axis.
std::vector<double> component(const std::vector<Vector3>& vectors, int axis) {
    std::vector<double> values;
    values.reserve(vectors.size());
    for (const Vector3& vector : vectors) {
        values.push_back(vector[axis]);
    }
    return values;
}

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

/// Returns the window of the zoomed view at this moment.
ScanWindow zoomAt(const Scene& scene, const TickSample& moment) {
    const Vector3& tip = moment.output.model.tip;
    const double half = zoomGrid(scene, moment).halfWidth;
    return {tip.x() - half, tip.x() + half, tip.y() - half, tip.y() + half};
}

constexpr int kPatchSamples = 241;

/// Radius of the tip as far as it matters for what is seen: a tip that is far blunter than what it
/// is on is as good as flat there [m].
double seenRadius(const Scene& scene, const TipState& state) {
    constexpr double kBlunt = 4.0;  // effective radii
    const double tip = scene.belief.tipRadius();
    return state.effectiveRadius > 0.0 ? std::min(tip, kBlunt * state.effectiveRadius) : tip;
}

/// Half the width of the zoomed view: the surface that visibly follows the tip, no wider, since it
/// is drawn true to scale.
double zoomHalfWidth(const Scene& scene, const TickSample& sample) {
    const double given = scene.description.zoomHalfWidth;
    if (given > 0.0) {
        return given;
    }
    // A contact that is displaced by d is about sqrt(R d) wide, with or without adhesion.
    const ContactState& contact = sample.output.model.contact;
    const double tip = seenRadius(scene, sample.output.model);
    const double reach = std::sqrt(tip * std::abs(contact.indentation));
    return std::max({4.0 * contact.contactRadius, std::min(4.0 * reach, tip), 0.1 * tip});
}

/// The distance between tip and surface, as its state is called. Adhesion may hold a tip in contact
/// above the undeformed surface, which it has pulled up.
std::string distanceText(const ContactState& contact) {
    const char* name = contact.region() != TipRegion::Contact ? "Gap"
                       : contact.indentation < 0.0            ? "Neck height"
                                                              : "Indentation";
    const bool isAbove = contact.region() != TipRegion::Contact || contact.indentation < 0.0;
    return name + (" " + formatSi(isAbove ? -contact.indentation : contact.indentation, "m"));
}

std::string captionOf(const Scene& scene, const TickSample& sample) {
    const TickOutput& out = sample.output;
    const ContactState& contact = out.model.contact;
    std::string caption = distanceText(contact) + ", contact radius " +
                          formatSi(contact.contactRadius, "m") + ", normal force " +
                          formatSi(out.model.normalForce, "N") + " (model), " +
                          formatSi(out.estimate.force.dot(out.model.normal), "N") +
                          " (estimate). Tip of " + formatSi(scene.belief.tipRadius(), "m") +
                          " radius on " + scene.description.sample.material.name + ".";
    std::replace(caption.begin(), caption.end(), '_', ' ');
    if (out.flags.has(Validity::LargeContact)) {
        caption += " Contact radius above 0.3 effective radii: strain beyond linear elasticity.";
    }
    if (out.flags.bits() != 0) {
        caption += " Flags: " + validityText(out.flags) + ".";
    }
    return caption;
}

std::string capitalized(std::string sentence) {
    sentence.front() = static_cast<char>(std::toupper(sentence.front()));
    return sentence;
}

/// The deformation that is drawn, and what there is to say of it.
struct DrawnContact {
    ContactDeformation deformation;
    std::string remark;
};

DrawnContact drawnContact(const Scene& scene, const TickSample& sample) {
    const TipState& state = sample.output.model;
    const DeformationModel model = scene.model.deformation;
    if (model != DeformationModel::HalfSpace) {
        return {.deformation = ContactDeformation(scene, state, model), .remark = ""};
    }
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    return {.deformation = ContactDeformation(scene, state, model, &answer),
            .remark = " " + capitalized(sentenceOf(answer)) + "."};
}

}  // namespace

void RunCurves::take(const TickSample& sample) {
    const TickOutput& out = sample.output;
    time_.push_back(sample.time);
    tip_.push_back(out.tip);
    estimate_.push_back(out.estimate.force);
    model_.push_back(out.model.force);
    indentation_.push_back(out.model.contact.indentation);
    contactRadius_.push_back(out.model.contact.contactRadius);
    bending_.push_back(sample.input.measurement.signals.bending);
    torsion_.push_back(sample.input.measurement.signals.torsion);
    takeLegs(sample);
}

void RunCurves::takeLegs(const TickSample& sample) {
    const TickOutput& out = sample.output;
    const Vector3& velocity = out.base.velocity;
    // Legs are where the base moves along z alone.
    if (std::hypot(velocity.x(), velocity.y()) >= 1e-3 * std::abs(velocity.z())) {
        return;
    }
    Leg& leg = velocity.z() < 0.0 ? approach_ : retract_;
    // The gap that the undeflected tip would have, taken from along the normal to along z.
    const Vector3& normal = out.model.closest.normal;
    const double gap =
        -out.model.contact.indentation + normal.dot(out.base.position - out.model.tip);
    leg.height.push_back(gap / normal.z());
    leg.force.push_back(out.estimate.force.z());
}

std::vector<Chart> RunCurves::charts() const {
    return {Chart{.title = "Force on the tip, estimated from the two signals",
                  .xLabel = "time",
                  .yLabel = "force",
                  .curves = {{.label = "Fx", .x = time_, .y = component(estimate_, 0)},
                             {.label = "Fy", .x = time_, .y = component(estimate_, 1)},
                             {.label = "Fz", .x = time_, .y = component(estimate_, 2)},
                             {.label = "Fz, contact model",
                              .x = time_,
                              .y = component(model_, 2),
                              .dashed = true}},
                  .xUnit = "s",
                  .yUnit = "N"},
            Chart{.title = "Approach and retract",
                  .xLabel = "height of the base above first touch",
                  .yLabel = "force along z",
                  .curves = {{.label = nameOf(CurveBranch::Approach),
                              .x = approach_.height,
                              .y = approach_.force},
                             {.label = nameOf(CurveBranch::Retract),
                              .x = retract_.height,
                              .y = retract_.force}},
                  .xUnit = "m",
                  .yUnit = "N"},
            Chart{.title = "Contact",
                  .xLabel = "time",
                  .yLabel = "length",
                  .curves = {{.label = "indentation", .x = time_, .y = indentation_},
                             {.label = "contact radius", .x = time_, .y = contactRadius_}},
                  .xUnit = "s",
                  .yUnit = "m"},
            Chart{.title = "Signals of the optical lever",
                  .xLabel = "time",
                  .yLabel = "angle",
                  .curves = {{.label = "bending", .x = time_, .y = bending_},
                             {.label = "torsion", .x = time_, .y = torsion_}},
                  .xUnit = "s",
                  .yUnit = "rad"}};
}

void RunCurves::write(const std::filesystem::path& path) const {
    writePng(path, layOut(charts(), {}));
}

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

PatchGrid zoomGrid(const Scene& scene, const TickSample& sample) {
    return {.halfWidth = zoomHalfWidth(scene, sample), .samples = kPatchSamples};
}

SurfacePatch zoomPatch(const Scene& scene, const TickSample& sample) {
    return zoomPatch(scene, sample, zoomGrid(scene, sample));
}

SurfacePatch zoomPatch(const Scene& scene, const TickSample& sample, const PatchGrid& grid) {
    return drawnPatch(scene, drawnContact(scene, sample).deformation, grid);
}

DeformationView contactView(const Scene& scene, const TickSample& sample,
                            const std::string& title) {
    return contactView(scene, sample, title, zoomGrid(scene, sample));
}

DeformationView contactView(const Scene& scene, const TickSample& sample, const std::string& title,
                            const PatchGrid& grid) {
    const TickOutput& out = sample.output;
    const auto [deformation, remark] = drawnContact(scene, sample);
    return {.title = title,
            .caption = captionOf(scene, sample) + remark,
            .patch = drawnPatch(scene, deformation, grid),
            .tipCenter = out.model.tip + Vector3(0.0, 0.0, scene.belief.tipRadius()),
            .tipRadius = scene.belief.tipRadius(),
            .shankHalfAngle = scene.description.tip.shape().shankHalfAngle(),
            .paraboloidReach = viewScale(scene).paraboloidReach,
            .tipDisplacement =
                [deformation = deformation](double distance) {
                    return deformation.tipDisplacement(distance);
                },
            .contactPoint = displacedPoint(scene, out.model, scene.model.deformation),
            .force = out.estimate.force,
            .contactRadius = out.model.contact.contactRadius};
}

}  // namespace asperity
