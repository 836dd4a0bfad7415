#include "core/studies/TradeOffTiers.h"

#include "core/scene/BelievedModel.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <iterator>

namespace asperity {

namespace {

/// Laws between which there is a choice; which of them is right depends on the materials.
std::vector<ContactLaw> lawsFor(const SceneDescription& scene) {
    std::vector<ContactLaw> laws;
    std::ranges::copy_if(kValues<ContactLaw>, std::back_inserter(laws), [&scene](ContactLaw law) {
        return (!isFilm(law) || isPossible(ModelTerm::FilmBase, scene)) &&
               (!isAdhesive(law) || isPossible(ModelTerm::Adhesion, scene));
    });
    std::ranges::stable_sort(
        laws, {}, [](ContactLaw law) { return isAdhesive(law) ? 1 + int{isSphere(law)} : 0; });
    return laws;
}

bool hasTable(const Scene& scene, ContactLaw law) {
    ForceModelOptions model = scene.model;
    model.law = law;
    model.solver = SolverTier::Table;
    return believedSystem(scene.description, model).contact.table() != nullptr;
}

void addOnce(std::vector<ForceModelOptions>& tiers, const ForceModelOptions& tier) {
    if (std::ranges::find(tiers, tier) == tiers.end()) {
        tiers.push_back(tier);
    }
}

}  // namespace

std::string nameOf(const FrameTier& tier) {
    const std::string side = std::to_string(tier.samples);
    return std::string(nameOf(tier.deformation)) + ", " + side + " x " + side;
}

std::vector<ForceModelOptions> tickTiers(const Scene& scene) {
    std::vector<ForceModelOptions> tiers;
    for (const ContactLaw law : lawsFor(scene.description)) {
        for (const SolverTier solver : {SolverTier::Table, SolverTier::Newton}) {
            if (solver == SolverTier::Table && !hasTable(scene, law)) {
                continue;
            }
            for (const SearchEffort effort :
                 {SearchEffort::Local, SearchEffort::Global, SearchEffort::Certified}) {
                tiers.push_back({.law = law, .solver = solver, .closestPointSearch = effort});
            }
        }
    }
    const ForceModelOptions own = ofForce(scene.model);
    addOnce(tiers, own);
    for (const ModelTerm left : kSwitchedTerms) {
        ForceModelOptions less = own;
        for (const ModelTerm term : kSwitchedTerms) {
            less.*traitsOf(term).option = term != left;
        }
        addOnce(tiers, ofForce(less));
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

}  // namespace asperity
