#include "app/reports/ContactView.h"

#include "core/SiFormat.h"
#include "core/deformation/ContactPatch.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Scene.h"
#include "core/words/ModelWords.h"
#include "ui/view/ViewScale.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr int kPatchSamples = 241;

/// Radius of the tip as far as it matters for what is seen: a tip that is far blunter than what it
/// stands on is as good as flat there [m].
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
