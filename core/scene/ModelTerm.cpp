#include "core/scene/ModelTerm.h"

#include "core/contact/ContactStatus.h"
#include "core/scene/SceneDescription.h"

namespace asperity {

namespace {

ContactLaw withoutAdhesion(ContactLaw law) {
    if (!isAdhesive(law)) {
        return law;
    }
    return isSphere(law) ? ContactLaw::Sneddon : ContactLaw::Hertz;
}

ContactLaw onParaboloid(ContactLaw law) { return lawLike(law, false, hasTail(law)).value_or(law); }

ContactLaw onSphere(ContactLaw law) {
    return isFilm(law) ? ContactLaw::Sneddon : lawLike(law, true, hasTail(law)).value_or(law);
}

ContactLaw withTail(ContactLaw law) {
    return isSphere(law) ? ContactLaw::SphereSplit : ContactLaw::Split;
}

ContactLaw withoutTail(ContactLaw law) {
    return isSphere(law) ? ContactLaw::SphereMaugis : ContactLaw::Maugis;
}

}  // namespace

bool exclude(ModelTerm a, ModelTerm b) noexcept {
    const auto are = [a, b](ModelTerm one, ModelTerm other) {
        return (a == one && b == other) || (a == other && b == one);
    };
    return are(ModelTerm::SphereCorrection, ModelTerm::SampleCurvature) ||
           (a != b && isOfLaw(a) && isOfLaw(b) &&
            (a == ModelTerm::FilmBase || b == ModelTerm::FilmBase));
}

bool isPossible(ModelTerm term, const SceneDescription& scene) noexcept {
    const SampleMaterial& material = scene.sample.material;
    switch (term) {
    case ModelTerm::Adhesion:
    case ModelTerm::VanDerWaalsTail:
        return material.workOfAdhesion >= kSmallestAdhesion;
    case ModelTerm::FilmBase:
        return material.filmThickness > 0.0;
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
    case ModelTerm::GlobalSearch:
        return model.footSearch != FootEffort::Local;
    case ModelTerm::OutsideDisplacement:
        return sharesDisplacement(model.deformation);
    case ModelTerm::HalfSpaceSolve:
        return model.deformation == DeformationTier::HalfSpace;
    default:
        return model.*traitsOf(term).option;
    }
}

ForceModelOptions without(ForceModelOptions model, ModelTerm term) noexcept {
    if (!has(model, term)) {
        return model;
    }
    switch (term) {
    case ModelTerm::Adhesion:
        model.law = withoutAdhesion(model.law);
        break;
    case ModelTerm::VanDerWaalsTail:
        model.law = withoutTail(model.law);
        break;
    case ModelTerm::SphereCorrection:
        model.law = onParaboloid(model.law);
        break;
    case ModelTerm::FilmBase:
        model.law = ContactLaw::Hertz;
        break;
    case ModelTerm::GlobalSearch:
        model.footSearch = FootEffort::Local;
        break;
    case ModelTerm::OutsideDisplacement:
        model.deformation = DeformationTier::ContactRadius;
        break;
    case ModelTerm::HalfSpaceSolve:
        model.deformation = DeformationTier::ClosedForm;
        break;
    default:
        model.*traitsOf(term).option = false;
    }
    return model;
}

ForceModelOptions with(ForceModelOptions model, ModelTerm term) noexcept {
    if (has(model, term)) {
        return model;
    }
    switch (term) {
    case ModelTerm::Adhesion:
    case ModelTerm::VanDerWaalsTail:
        model.law = withTail(model.law);
        break;
    case ModelTerm::SphereCorrection:
        model.law = onSphere(model.law);
        break;
    case ModelTerm::FilmBase:
        model.law = ContactLaw::HertzFilm;
        break;
    case ModelTerm::GlobalSearch:
        model.footSearch = FootEffort::Certified;
        break;
    case ModelTerm::OutsideDisplacement:
        model.deformation = DeformationTier::ClosedForm;
        break;
    case ModelTerm::HalfSpaceSolve:
        model.deformation = DeformationTier::HalfSpace;
        break;
    default:
        model.*traitsOf(term).option = true;
    }
    return model;
}

}  // namespace asperity
