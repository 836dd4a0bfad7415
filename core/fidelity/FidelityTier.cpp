#include "core/fidelity/FidelityTier.h"

#include "core/scene/ModelTerm.h"

#include <algorithm>
#include <array>
#include <utility>

namespace asperity {

namespace {

/// Laws between which there is a choice; which of them is right depends on the materials.
std::vector<ContactLaw> lawsFor(const SceneDescription& scene) {
    std::vector<ContactLaw> laws{ContactLaw::Hertz, ContactLaw::Sneddon};
    if (isPossible(ModelTerm::FilmBase, scene)) {
        laws.push_back(ContactLaw::HertzFilm);
    }
    if (isPossible(ModelTerm::Adhesion, scene)) {
        // Not insert(): GCC 12 with -fsanitize=thread sees it write beyond the end (it does not).
        for (const ContactLaw law :
             {ContactLaw::Dmt, ContactLaw::Jkr, ContactLaw::Maugis, ContactLaw::Split,
              ContactLaw::SphereJkr, ContactLaw::SphereMaugis, ContactLaw::SphereSplit}) {
            laws.push_back(law);
        }
    }
    return laws;
}

bool hasTable(const Scene& scene, ContactLaw law) {
    SceneModel model = scene.model;
    model.law.law = law;
    model.solver = SolverTier::Table;
    return believedSystem(scene.description, model).contact.table() != nullptr;
}

/// Whether a tier reckons with a term, by term.
constexpr std::array<std::pair<ModelTerm, bool TickTier::*>, 4> kTermsOfTier{
    {{ModelTerm::Friction, &TickTier::friction},
     {ModelTerm::Torsion, &TickTier::torsion},
     {ModelTerm::MountTilt, &TickTier::mountTilt},
     {ModelTerm::SampleCurvature, &TickTier::curvature}}};

TickTier withAllTerms(TickTier tier) {
    for (const auto& [term, member] : kTermsOfTier) {
        tier.*member = true;
    }
    return tier;
}

void addOnce(std::vector<TickTier>& tiers, const TickTier& tier) {
    if (std::ranges::find(tiers, tier) == tiers.end()) {
        tiers.push_back(tier);
    }
}

}  // namespace

std::string TickTier::name() const {
    std::string text = nameOf(law);
    text += solver == SolverTier::Table ? ", table" : "";
    text += solver == SolverTier::Exact ? ", afresh" : "";
    text += std::string(", ") + keyOf(footSearch) + " feet";
    text += decoupling == DecouplingTier::Planar ? ", planar" : "";
    const char* before = ", without ";
    for (const auto& [term, member] : kTermsOfTier) {
        if (!(this->*member)) {
            text += std::string(before) + asperity::nameOf(term);
            before = ", ";
        }
    }
    return text;
}

std::string FrameTier::name() const {
    return std::string(nameOf(deformation)) + ", " + std::to_string(samples) + " x " +
           std::to_string(samples);
}

std::vector<TickTier> tickTiers(const Scene& scene) {
    std::vector<TickTier> tiers;
    for (const ContactLaw law : lawsFor(scene.description)) {
        for (const SolverTier solver : {SolverTier::Table, SolverTier::Newton}) {
            if (solver == SolverTier::Table && !hasTable(scene, law)) {
                continue;
            }
            for (const FootEffort effort :
                 {FootEffort::Local, FootEffort::Global, FootEffort::Certified}) {
                tiers.push_back({.law = law, .solver = solver, .footSearch = effort});
            }
        }
    }
    const TickTier own = tierOf(scene.model);
    addOnce(tiers, own);
    for (const auto& [term, member] : kTermsOfTier) {
        TickTier less = withAllTerms(own);
        less.*member = isSphere(own.law) && term == ModelTerm::SampleCurvature;
        addOnce(tiers, less);
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
    model.friction = tier.friction;
    model.torsion = tier.torsion;
    model.mountTilt = tier.mountTilt;
    model.curvature = tier.curvature;
    return model;
}

TickTier tierOf(const SceneModel& model) noexcept {
    return {.law = model.law.law,
            .solver = model.solver,
            .footSearch = model.footSearch,
            .decoupling = model.decoupling,
            .friction = model.friction,
            .torsion = model.torsion,
            .mountTilt = model.mountTilt,
            .curvature = model.curvature || isSphere(model.law.law)};
}

}  // namespace asperity
