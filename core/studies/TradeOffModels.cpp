#include "core/studies/TradeOffModels.h"

#include "core/fidelity/ReferenceModels.h"
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
    model.solver = SolverSetting::Table;
    return believedSystem(scene.description, model).contact.table() != nullptr;
}

void addOnce(std::vector<ForceModelOptions>& all, const ForceModelOptions& options) {
    if (std::ranges::find(all, options) == all.end()) {
        all.push_back(options);
    }
}

}  // namespace

std::string nameOf(const FrameOptions& options) {
    const std::string side = std::to_string(options.samples);
    return std::string(nameOf(options.deformation)) + ", " + side + " x " + side;
}

std::vector<ForceModelOptions> tickModels(const Scene& scene) {
    const bool attracts = isInScene(ModelTerm::BodyAttraction, scene);
    std::vector<ForceModelOptions> all;
    for (const ContactLaw law : lawsFor(scene.description)) {
        for (const SolverSetting solver : {SolverSetting::Table, SolverSetting::Newton}) {
            if (solver == SolverSetting::Table && !hasTable(scene, law)) {
                continue;
            }
            for (const SearchEffort effort :
                 {SearchEffort::Local, SearchEffort::Global, SearchEffort::Certified}) {
                all.push_back(ofForce({.law = law,
                                       .solver = solver,
                                       .closestPointSearch = effort,
                                       .bodyAttraction = attracts}));
            }
        }
    }
    const ForceModelOptions own = ofForce(scene.model);
    addOnce(all, own);
    for (const ModelTerm left : kSwitchedTerms) {
        ForceModelOptions less = own;
        for (const ModelTerm term : kSwitchedTerms) {
            less.*traitsOf(term).option = term != left && isInScene(term, scene);
        }
        addOnce(all, ofForce(less));
    }
    return all;
}

std::vector<FrameOptions> frameOptions() {
    std::vector<FrameOptions> all;
    for (const DeformationModel deformation :
         {DeformationModel::FourPoint, DeformationModel::ContactRadius,
          DeformationModel::ClosedForm, DeformationModel::HalfSpace}) {
        for (const int samples : {25, 49, 97}) {
            all.push_back({deformation, samples});
        }
    }
    return all;
}

}  // namespace asperity
