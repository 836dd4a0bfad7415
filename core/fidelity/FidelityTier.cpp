#include "core/fidelity/FidelityTier.h"

#include <array>

namespace asperity {

namespace {

/// Laws between which there is a choice; which of them is right depends on the materials.
std::vector<ContactLaw> lawsFor(const Scene& scene) {
    if (scene.belief.contact.filmThickness() > 0.0) {
        return {ContactLaw::Hertz, ContactLaw::HertzFilm};
    }
    if (scene.description.sample.material.workOfAdhesion == 0.0) {
        return {ContactLaw::Hertz, ContactLaw::Sneddon};
    }
    return {ContactLaw::Hertz, ContactLaw::Jkr, ContactLaw::Maugis, ContactLaw::Split,
            ContactLaw::SphereMaugis};
}

bool hasTable(const Scene& scene, ContactLaw law) {
    SceneModel model = scene.model;
    model.law.law = law;
    model.solver = SolverTier::Table;
    return believedSystem(scene.description, model).contact.table() != nullptr;
}

}  // namespace

const char* nameOf(DeformationTier deformation) noexcept {
    switch (deformation) {
    case DeformationTier::FourPoint:
        return "four points";
    case DeformationTier::ContactRadius:
        return "contact radius";
    case DeformationTier::ClosedForm:
        return "closed form";
    case DeformationTier::HalfSpace:
        return "half-space";
    }
    return "unknown";
}

std::string TickTier::name() const {
    std::string text = nameOf(law);
    text += solver == SolverTier::Table ? ", table" : "";
    text += solver == SolverTier::Exact ? ", afresh" : "";
    text += std::string(", ") + effortName(footSearch) + " feet";
    text += decoupling == DecouplingTier::Planar ? ", planar" : "";
    return text;
}

std::string FrameTier::name() const {
    return std::string(nameOf(deformation)) + ", " + std::to_string(samples) + " x " +
           std::to_string(samples);
}

std::vector<TickTier> tickTiers(const Scene& scene) {
    std::vector<TickTier> tiers;
    for (const ContactLaw law : lawsFor(scene)) {
        for (const SolverTier solver : {SolverTier::Table, SolverTier::Newton}) {
            if (solver == SolverTier::Table && !hasTable(scene, law)) {
                continue;
            }
            for (const FootEffort effort :
                 {FootEffort::Local, FootEffort::Global, FootEffort::Certified}) {
                tiers.push_back({law, solver, effort});
            }
        }
    }
    return tiers;
}

std::vector<FrameTier> frameTiers() {
    std::vector<FrameTier> tiers;
    for (const DeformationTier deformation :
         {DeformationTier::FourPoint, DeformationTier::ContactRadius, DeformationTier::ClosedForm,
          DeformationTier::HalfSpace}) {
        for (const int samples : {25, 49, 97}) {
            tiers.push_back({deformation, samples});
        }
    }
    return tiers;
}

SceneModel modelWithTier(SceneModel model, const TickTier& tier) {
    model.law = {tier.law, "as the tier asks"};
    model.solver = tier.solver;
    model.footSearch = tier.footSearch;
    model.decoupling = tier.decoupling;
    return model;
}

TickTier tierOf(const SceneModel& model) noexcept {
    return {model.law.law, model.solver, model.footSearch, model.decoupling};
}

}  // namespace asperity
