#include "core/fidelity/TermFacts.h"

#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

double curvatureOf(const ModelRun& run) {
    return largestOf(run, [](const TipState& state) {
        return std::max(std::abs(state.closest.curvatures.largest),
                        std::abs(state.closest.curvatures.smallest));
    });
}

}  // namespace

TermFact factOf(ModelTerm term, const Scene& scene, const ModelRun& run) {
    const SampleMaterial& material = scene.description.sample.material;
    switch (term) {
    case ModelTerm::Adhesion:
        return {largestOf(run, [](const TipState& s) { return -s.normalForce; }),
                largestOf(run, [](const TipState& s) { return s.normalForce; })};
    case ModelTerm::VanDerWaalsTail:
        return {scene.belief.contact.lambda()};
    case ModelTerm::SphereCorrection:
        return {largestOf(run, [](const TipState& s) { return s.contactRatio; })};
    case ModelTerm::FilmBase:
        return {largestOf(run, [](const TipState& s) { return s.contact.contactRadius; }) /
                material.filmThickness};
    case ModelTerm::SampleCurvature:
        return {curvatureOf(run) * scene.belief.tipRadius()};
    case ModelTerm::BodyAttraction:
        return {largestOf(
            run, [](const TipState& s) { return std::abs(s.body.at(s.contact.indentation)); })};
    case ModelTerm::Friction:
        return {material.friction.coefficient, material.friction.shearStrength};
    case ModelTerm::Torsion: {
        const Matrix3& c = scene.belief.cantilever.complianceInCantileverFrame();
        return {c(1, 1) / c(2, 2)};
    }
    case ModelTerm::MountTilt:
        return {scene.description.probe.mountTilt};
    case ModelTerm::GlobalSearch:
        return {scene.shape ? std::numeric_limits<double>::infinity()
                            : scene.surface.bounds().all().concavity * scene.belief.tipRadius()};
    case ModelTerm::OutsideDisplacement:
    case ModelTerm::HalfSpaceSolve:
        break;
    }
    return {};
}

}  // namespace asperity
