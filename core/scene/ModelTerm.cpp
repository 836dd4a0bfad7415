#include "core/scene/ModelTerm.h"

#include "core/contact/ContactState.h"
#include "core/scene/SceneDescription.h"

namespace asperity {

namespace {

/// The law that has the term, or has it not, instead of one with which it is the other way round.
ContactLaw switched(ContactLaw law, ModelTerm term, bool on) {
    switch (term) {
    case ModelTerm::Adhesion:
        if (!on) {
            return isSphere(law) ? ContactLaw::Sneddon : ContactLaw::Hertz;
        }
        [[fallthrough]];
    case ModelTerm::VanDerWaalsTail:
        if (on) {
            return isSphere(law) ? ContactLaw::SphereSplit : ContactLaw::Split;
        }
        return isSphere(law) ? ContactLaw::SphereMaugis : ContactLaw::Maugis;
    case ModelTerm::SphereCorrection:
        return isFilm(law) ? ContactLaw::Sneddon : lawLike(law, on, hasTail(law)).value_or(law);
    default:
        return on ? ContactLaw::HertzFilm : ContactLaw::Hertz;
    }
}

ForceModelOptions switched(ForceModelOptions model, ModelTerm term, bool on) {
    const auto option = traitsOf(term).option;
    // An option without effect under the present law would have one under the next.
    const bool isSet = option && model.*option != on;
    if (has(model, term) == on && !isSet) {
        return model;
    }
    if (option) {
        if (on && term == ModelTerm::BodyAttraction && !hasTail(model.law)) {
            model.law = switched(model.law, ModelTerm::VanDerWaalsTail, true);
        }
        if (on && term == ModelTerm::RetractWork && !isJkr(model.law)) {
            model.law = isSphere(model.law) ? ContactLaw::SphereJkr : ContactLaw::Jkr;
        }
        if (on && term == ModelTerm::Relaxation && isAdhesive(model.law)) {
            model.law = switched(model.law, ModelTerm::Adhesion, false);
        }
        model.*option = on;
    } else if (isOfLaw(term)) {
        model.law = switched(model.law, term, on);
    } else if (term == ModelTerm::GlobalSearch) {
        model.closestPointSearch = on ? SearchEffort::Certified : SearchEffort::Local;
    } else if (term == ModelTerm::OutsideDisplacement) {
        model.deformation = on ? DeformationModel::ClosedForm : DeformationModel::ContactRadius;
    } else {
        model.deformation = on ? DeformationModel::HalfSpace : DeformationModel::ClosedForm;
    }
    return model;
}

}  // namespace

bool exclude(ModelTerm a, ModelTerm b) noexcept {
    const auto are = [a, b](ModelTerm one, ModelTerm other) {
        return (a == one && b == other) || (a == other && b == one);
    };
    return are(ModelTerm::SphereCorrection, ModelTerm::SampleCurvature) ||
           are(ModelTerm::RetractWork, ModelTerm::VanDerWaalsTail) ||
           are(ModelTerm::Relaxation, ModelTerm::Adhesion) ||
           (a != b && isOfLaw(a) && isOfLaw(b) &&
            (a == ModelTerm::FilmBase || b == ModelTerm::FilmBase));
}

bool isPossible(ModelTerm term, const SceneDescription& scene) noexcept {
    const SampleMaterial& material = scene.sample.material;
    switch (term) {
    case ModelTerm::Adhesion:
    case ModelTerm::VanDerWaalsTail:
        return material.workOfAdhesion >= kMinAdhesion;
    case ModelTerm::BodyAttraction:
        return material.workOfAdhesion >= kMinAdhesion && !scene.sample.shape;
    case ModelTerm::FilmBase:
        return material.filmThickness > 0.0;
    case ModelTerm::RetractWork:
        return material.hasTwoWorks();
    case ModelTerm::Relaxation:
        return material.relaxingModulus > 0.0;
    case ModelTerm::Drag:
        return material.drag > 0.0;
    default:
        return true;
    }
}

bool has(const ForceModelOptions& model, ModelTerm term) noexcept {
    switch (term) {
    case ModelTerm::Adhesion:
        return isAdhesive(model.law);
    case ModelTerm::VanDerWaalsTail:
        return hasTail(model.law);
    case ModelTerm::SphereCorrection:
        return isSphere(model.law);
    case ModelTerm::FilmBase:
        return isFilm(model.law);
    case ModelTerm::SampleCurvature:
        return model.curvature && !isSphere(model.law);
    case ModelTerm::BodyAttraction:
        return model.bodyAttraction && hasTail(model.law);
    case ModelTerm::RetractWork:
        return model.retractWork && isJkr(model.law);
    case ModelTerm::Relaxation:
        return model.relaxation && !isAdhesive(model.law);
    case ModelTerm::GlobalSearch:
        return model.closestPointSearch != SearchEffort::Local;
    case ModelTerm::OutsideDisplacement:
        return sharesDisplacement(model.deformation);
    case ModelTerm::HalfSpaceSolve:
        return model.deformation == DeformationModel::HalfSpace;
    default:
        return model.*traitsOf(term).option;
    }
}

ForceModelOptions without(ForceModelOptions model, ModelTerm term) noexcept {
    return switched(model, term, false);
}

ForceModelOptions with(ForceModelOptions model, ModelTerm term) noexcept {
    return switched(model, term, true);
}

}  // namespace asperity
