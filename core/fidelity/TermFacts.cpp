#include "core/fidelity/TermFacts.h"

#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

std::string curvatureFact(const Scene& scene, const ModelRun& run) {
    const double curvature = largestOf(run, [](const TipState& state) {
        return std::max(std::abs(state.closest.curvatures.largest),
                        std::abs(state.closest.curvatures.smallest));
    });
    return formatted("the sample is curved by up to %.2g of the tip's own curvature",
                     curvature * scene.belief.tipRadius());
}

std::string searchFact(const Scene& scene) {
    if (scene.shape) {
        return "a shape may come near at several places";
    }
    return formatted("hollows are curved by up to %.2g of the tip's own curvature",
                     scene.surface.bounds().all().concavity * scene.belief.tipRadius());
}

}  // namespace

std::string factOf(ModelTerm term, const Scene& scene, const ModelRun& run) {
    const SampleMaterial& material = scene.description.sample.material;
    switch (term) {
    case ModelTerm::Adhesion:
        return formatted("it pulls with up to %.3g nN, pressed by up to %.3g nN",
                         1e9 * largestOf(run, [](const TipState& s) { return -s.normalForce; }),
                         1e9 * largestOf(run, [](const TipState& s) { return s.normalForce; }));
    case ModelTerm::VanDerWaalsTail:
        return formatted("attraction reaches across the gap; transition parameter %.2g",
                         scene.belief.contact.lambda());
    case ModelTerm::SphereCorrection:
        return formatted("the contact is up to %.2g tip radii wide",
                         largestOf(run, [](const TipState& s) { return s.contactRatio; }));
    case ModelTerm::FilmBase:
        return formatted("the contact is up to %.2g film thicknesses wide",
                         largestOf(run, [](const TipState& s) { return s.contact.contactRadius; }) /
                             material.filmThickness);
    case ModelTerm::SampleCurvature:
        return curvatureFact(scene, run);
    case ModelTerm::Friction:
        return formatted("friction coefficient %.2g, shear strength %.2g MPa",
                         material.friction.coefficient, 1e-6 * material.friction.shearStrength);
    case ModelTerm::Torsion: {
        const Matrix3& c = scene.belief.cantilever.complianceInCantileverFrame();
        return formatted("across the lever the tip yields %.2g times as much as along z",
                         c(1, 1) / c(2, 2));
    }
    case ModelTerm::MountTilt:
        return formatted("the lever is tilted by %.3g degrees",
                         scene.description.probe.mountTilt * 180.0 / std::numbers::pi);
    case ModelTerm::GlobalSearch:
        return searchFact(scene);
    case ModelTerm::OutsideDisplacement:
    case ModelTerm::HalfSpaceSolve:
        break;
    }
    return {};
}

std::string whyImpossible(ModelTerm term) {
    return term == ModelTerm::FilmBase ? "the sample is no film" : "the materials do not adhere";
}

}  // namespace asperity
