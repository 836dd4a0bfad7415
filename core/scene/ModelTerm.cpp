#include "core/scene/ModelTerm.h"

namespace asperity {

namespace {

bool isAdhesive(ContactLaw law) {
    return law != ContactLaw::Hertz && law != ContactLaw::Sneddon && law != ContactLaw::HertzFilm;
}

ContactLaw withoutAdhesion(ContactLaw law) {
    if (!isAdhesive(law)) {
        return law;
    }
    return isSphere(law) ? ContactLaw::Sneddon : ContactLaw::Hertz;
}

ContactLaw onParaboloid(ContactLaw law) {
    switch (law) {
    case ContactLaw::Sneddon:
        return ContactLaw::Hertz;
    case ContactLaw::SphereJkr:
        return ContactLaw::Jkr;
    case ContactLaw::SphereMaugis:
        return ContactLaw::Maugis;
    default:
        return law;
    }
}

ContactLaw onSphere(ContactLaw law) {
    switch (law) {
    case ContactLaw::Hertz:
        return ContactLaw::Sneddon;
    case ContactLaw::Jkr:
        return ContactLaw::SphereJkr;
    case ContactLaw::Maugis:
    case ContactLaw::Split:
        return ContactLaw::SphereMaugis;
    default:
        return law;
    }
}

}  // namespace

const char* nameOf(ModelTerm term) noexcept {
    switch (term) {
    case ModelTerm::Adhesion:
        return "adhesion";
    case ModelTerm::VanDerWaalsTail:
        return "van der Waals tail";
    case ModelTerm::SphereCorrection:
        return "sphere correction";
    case ModelTerm::SampleCurvature:
        return "sample curvature";
    case ModelTerm::Friction:
        return "friction";
    case ModelTerm::Torsion:
        return "lever torsion";
    case ModelTerm::MountTilt:
        return "mount tilt";
    case ModelTerm::GlobalSearch:
        return "global search";
    case ModelTerm::OutsideDisplacement:
        return "outside displacement";
    case ModelTerm::HalfSpaceSolve:
        return "half-space solve";
    }
    return "unknown";
}

bool isOfSurface(ModelTerm term) noexcept {
    return term == ModelTerm::OutsideDisplacement || term == ModelTerm::HalfSpaceSolve;
}

bool isSettled(ModelTerm term, const SceneDescription& scene) noexcept {
    switch (term) {
    case ModelTerm::Adhesion:
        return scene.law.has_value() || scene.terms.adhesion.has_value();
    case ModelTerm::VanDerWaalsTail:
        return scene.law.has_value() || scene.terms.vanDerWaalsTail.has_value();
    case ModelTerm::SphereCorrection:
        return scene.law.has_value() || scene.terms.sphereCorrection.has_value();
    case ModelTerm::SampleCurvature:
        return scene.terms.curvature.has_value();
    case ModelTerm::Friction:
        return scene.terms.friction.has_value();
    case ModelTerm::Torsion:
        return scene.terms.torsion.has_value();
    case ModelTerm::MountTilt:
        return scene.terms.mountTilt.has_value();
    case ModelTerm::GlobalSearch:
        return scene.footSearch.has_value();
    case ModelTerm::OutsideDisplacement:
    case ModelTerm::HalfSpaceSolve:
        return scene.deformation.has_value();
    }
    return true;
}

bool has(const SceneModel& model, ModelTerm term) noexcept {
    switch (term) {
    case ModelTerm::Adhesion:
        return isAdhesive(model.law.law);
    case ModelTerm::VanDerWaalsTail:
        return model.law.law == ContactLaw::Split;
    case ModelTerm::SphereCorrection:
        return isSphere(model.law.law);
    case ModelTerm::SampleCurvature:
        return model.curvature && !isSphere(model.law.law);
    case ModelTerm::Friction:
        return model.friction;
    case ModelTerm::Torsion:
        return model.torsion;
    case ModelTerm::MountTilt:
        return model.mountTilt;
    case ModelTerm::GlobalSearch:
        return model.footSearch != FootEffort::Local;
    case ModelTerm::OutsideDisplacement:
        return sharesDisplacement(model.deformation);
    case ModelTerm::HalfSpaceSolve:
        return model.deformation == DeformationTier::HalfSpace;
    }
    return false;
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
        model.law.law = ContactLaw::Maugis;
        break;
    case ModelTerm::SphereCorrection:
        model.law.law = onParaboloid(model.law.law);
        break;
    case ModelTerm::SampleCurvature:
        model.curvature = false;
        break;
    case ModelTerm::Friction:
        model.friction = false;
        break;
    case ModelTerm::Torsion:
        model.torsion = false;
        break;
    case ModelTerm::MountTilt:
        model.mountTilt = false;
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
    }
    return model;
}

SceneModel with(SceneModel model, ModelTerm term) {
    switch (term) {
    case ModelTerm::Adhesion:
        model.law.law = isSphere(model.law.law) ? ContactLaw::SphereMaugis : ContactLaw::Split;
        break;
    case ModelTerm::VanDerWaalsTail:
        model.law.law = ContactLaw::Split;
        break;
    case ModelTerm::SphereCorrection:
        model.law.law = onSphere(model.law.law);
        break;
    case ModelTerm::SampleCurvature:
        model.curvature = true;
        break;
    case ModelTerm::Friction:
        model.friction = true;
        break;
    case ModelTerm::Torsion:
        model.torsion = true;
        break;
    case ModelTerm::MountTilt:
        model.mountTilt = true;
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
    }
    return model;
}

SceneDescription settled(SceneDescription scene, const SceneModel& model) {
    TermChoices& terms = scene.terms;
    if (!scene.law) {
        terms.adhesion = has(model, ModelTerm::Adhesion);
        terms.vanDerWaalsTail = has(model, ModelTerm::VanDerWaalsTail);
        terms.sphereCorrection = has(model, ModelTerm::SphereCorrection);
    }
    terms.curvature = model.curvature;
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
