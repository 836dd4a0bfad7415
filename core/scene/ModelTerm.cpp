#include "core/scene/ModelTerm.h"

#include "core/contact/ContactStatus.h"

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

/// Of the terms that a model says yes or no to.
bool SceneModel::*switchOf(ModelTerm term) {
    switch (term) {
    case ModelTerm::SampleCurvature:
        return &SceneModel::curvature;
    case ModelTerm::Friction:
        return &SceneModel::friction;
    case ModelTerm::Torsion:
        return &SceneModel::torsion;
    default:
        return &SceneModel::mountTilt;
    }
}

}  // namespace

bool isOfLaw(ModelTerm term) noexcept {
    return term == ModelTerm::Adhesion || term == ModelTerm::VanDerWaalsTail ||
           term == ModelTerm::SphereCorrection || term == ModelTerm::FilmBase;
}

bool isOfSurface(ModelTerm term) noexcept {
    return term == ModelTerm::OutsideDisplacement || term == ModelTerm::HalfSpaceSolve;
}

std::optional<bool> TermChoices::*choiceMember(ModelTerm term) noexcept {
    switch (term) {
    case ModelTerm::Adhesion:
        return &TermChoices::adhesion;
    case ModelTerm::VanDerWaalsTail:
        return &TermChoices::vanDerWaalsTail;
    case ModelTerm::SphereCorrection:
        return &TermChoices::sphereCorrection;
    case ModelTerm::FilmBase:
        return &TermChoices::filmBase;
    case ModelTerm::SampleCurvature:
        return &TermChoices::curvature;
    case ModelTerm::Friction:
        return &TermChoices::friction;
    case ModelTerm::Torsion:
        return &TermChoices::torsion;
    case ModelTerm::MountTilt:
        return &TermChoices::mountTilt;
    case ModelTerm::GlobalSearch:
    case ModelTerm::OutsideDisplacement:
    case ModelTerm::HalfSpaceSolve:
        break;
    }
    return nullptr;
}

bool isSettled(ModelTerm term, const SceneDescription& scene) noexcept {
    if (isOfLaw(term) && scene.law) {
        return true;
    }
    if (const auto member = choiceMember(term)) {
        return (scene.terms.*member).has_value();
    }
    return isOfSurface(term) ? scene.deformation.has_value() : scene.footSearch.has_value();
}

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

bool has(const SceneModel& model, ModelTerm term) noexcept {
    switch (term) {
    case ModelTerm::Adhesion:
        return isAdhesive(model.law.law);
    case ModelTerm::VanDerWaalsTail:
        return hasTail(model.law.law);
    case ModelTerm::SphereCorrection:
        return isSphere(model.law.law);
    case ModelTerm::FilmBase:
        return isFilm(model.law.law);
    case ModelTerm::SampleCurvature:
        return model.curvature && !isSphere(model.law.law);
    case ModelTerm::GlobalSearch:
        return model.footSearch != FootEffort::Local;
    case ModelTerm::OutsideDisplacement:
        return sharesDisplacement(model.deformation);
    case ModelTerm::HalfSpaceSolve:
        return model.deformation == DeformationTier::HalfSpace;
    default:
        return model.*switchOf(term);
    }
}

SceneModel without(SceneModel model, ModelTerm term) {
    if (!has(model, term)) {
        return model;
    }
    switch (term) {
    case ModelTerm::Adhesion:
        model.law.law = withoutAdhesion(model.law.law);
        break;
    case ModelTerm::VanDerWaalsTail:
        model.law.law = withoutTail(model.law.law);
        break;
    case ModelTerm::SphereCorrection:
        model.law.law = onParaboloid(model.law.law);
        break;
    case ModelTerm::FilmBase:
        model.law.law = ContactLaw::Hertz;
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
        model.*switchOf(term) = false;
    }
    return model;
}

SceneModel with(SceneModel model, ModelTerm term) {
    if (has(model, term)) {
        return model;
    }
    switch (term) {
    case ModelTerm::Adhesion:
    case ModelTerm::VanDerWaalsTail:
        model.law.law = withTail(model.law.law);
        break;
    case ModelTerm::SphereCorrection:
        model.law.law = onSphere(model.law.law);
        break;
    case ModelTerm::FilmBase:
        model.law.law = ContactLaw::HertzFilm;
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
        model.*switchOf(term) = true;
    }
    return model;
}

SceneDescription settled(SceneDescription scene, const SceneModel& model) {
    TermChoices& terms = scene.terms;
    if (!scene.law) {
        terms.adhesion = has(model, ModelTerm::Adhesion);
        terms.vanDerWaalsTail = has(model, ModelTerm::VanDerWaalsTail);
        terms.sphereCorrection = has(model, ModelTerm::SphereCorrection);
        terms.filmBase = has(model, ModelTerm::FilmBase);
    }
    terms.curvature = has(model, ModelTerm::SampleCurvature);
    terms.friction = model.friction;
    terms.torsion = model.torsion;
    terms.mountTilt = model.mountTilt;
    scene.footSearch = model.footSearch;
    scene.deformation = model.deformation;
    scene.solver = model.solver;
    scene.decoupling = model.decoupling;
    return scene;
}

}  // namespace asperity
