#include "tests/core/fidelity/StatedErrors.h"

#include "core/Units.h"
#include "core/fidelity/ModelRun.h"
#include "core/fidelity/SampledRuns.h"
#include "core/map/PixelCycle.h"
#include "tests/support/TestScenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace asperity::test {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

SampleMaterial siliconOxide() {
    return {.name = "silicon_oxide",
            .elastic = {.youngsModulus = 70e9, .poissonRatio = 0.27},
            .workOfAdhesion = 0.2,
            .friction = {.coefficient = 0.2}};
}

SceneDescription sceneOf(const ShapeDescription& shape, const SampleMaterial& material) {
    SceneDescription scene = plainScene();
    scene.sample.shape = shape;
    scene.sample.material = material;
    scene.truth.material = material;
    return scene;
}

SceneDescription sphere(double radius) {
    return sceneOf({.kind = ShapeKind::Sphere, .radius = radius}, siliconOxide());
}

SceneDescription sphereAsPlane(double radius) {
    SceneDescription scene = sphere(radius);
    scene.choices.curvature = false;
    return scene;
}

SceneDescription plane(double slope, const SampleMaterial& material = {}) {
    return sceneOf({.kind = ShapeKind::Plane, .slope = slope}, material);
}

SceneDescription film(double thickness, double adhesion) {
    SampleMaterial material;
    material.filmThickness = thickness;
    material.workOfAdhesion = adhesion;
    return plane(0.0, material);
}

SceneDescription withoutFriction(double coefficient) {
    SampleMaterial material = siliconOxide();
    material.friction.coefficient = coefficient;
    SceneDescription scene = plane(0.0, material);
    scene.choices.friction = false;
    return scene;
}

SceneDescription withoutTorsion(SceneDescription scene) {
    scene.choices.torsion = false;
    return scene;
}

SceneDescription withoutTilt(SceneDescription scene, double tilt) {
    scene.probe.mountTilt = tilt;
    scene.choices.mountTilt = false;
    return scene;
}

/// Force over the base on one way of a curve [N]; none: beyond its ends.
std::optional<double> forceAt(const std::vector<PixelCurvePoint>& way, double base) {
    for (std::size_t i = 1; i < way.size(); ++i) {
        const PixelCurvePoint& a = way[i - 1];
        const PixelCurvePoint& b = way[i];
        if (a.base != b.base && (a.base - base) * (b.base - base) <= 0.0) {
            return std::lerp(a.force, b.force, (base - a.base) / (b.base - a.base));
        }
    }
    return std::nullopt;
}

/// Height of the base where the curve jumps; where it does not, where it first or last bears a
/// force of contact: at the lowest free point [m].
double baseOf(const std::optional<PixelCurvePoint>& jump, const std::vector<PixelCurvePoint>& way) {
    if (jump) {
        return jump->base;
    }
    double lowest = way.front().force > way.back().force ? way.back().base : way.front().base;
    for (const PixelCurvePoint& point : way) {
        lowest = point.force <= 0.0 ? std::min(lowest, point.base) : lowest;
    }
    return lowest;
}

/// Root mean square of the difference where both hold the tip or both do not, over that of the
/// reference; where one of them does, the share of the mean square. From the higher setpoint up.
double rmsOfCurves(const PixelCurve& curve, const PixelCurve& reference) {
    constexpr int kSamples = 2000;  // of each part: up to the jumps, between them, beyond
    const double low = std::max(curve.retract.front().base, reference.retract.front().base);
    const double high = std::max(curve.approach.front().base, reference.approach.front().base);
    double alike = 0.0;
    double byOne = 0.0;
    double scale = 0.0;
    const auto addPart = [&](const auto& way, double from, double to, double& sum) {
        for (int i = 0; i < kSamples; ++i) {
            const double share = (i + 0.5) / kSamples;
            // Beyond the jumps the attraction falls fast: samples are denser near to them.
            const double base = std::lerp(from, to, share * share);
            const double weight = 2.0 * share * (to - from) / kSamples;
            const double exact = forceAt(reference.*way, base).value_or(0.0);
            const double error = forceAt(curve.*way, base).value_or(0.0) - exact;
            sum += weight * error * error;
            scale += weight * exact * exact;
        }
    };
    const auto add = [&](const auto& way, const auto& jump) {
        const double one = std::max(low, baseOf(curve.*jump, curve.*way));
        const double other = std::max(low, baseOf(reference.*jump, reference.*way));
        addPart(way, low, std::min(one, other), alike);
        addPart(way, std::min(one, other), std::max(one, other), byOne);
        addPart(way, std::max(one, other), high, alike);
    };
    add(&PixelCurve::approach, &PixelCurve::snapIn);
    add(&PixelCurve::retract, &PixelCurve::pullOff);
    return std::sqrt(alike / scale) + (byOne / scale);
}

double pullAfterSnapIn(const PixelCurve& curve) {
    double pull = 0.0;
    for (const PixelCurvePoint& point : curve.approach) {
        pull = std::max(pull, -point.force);
    }
    return pull;
}

double shareOf(double value, double reference) {
    const bool isNone = std::abs(reference) < 1e-18;  // of forces and works of rounding [N, J]
    return value == reference || (isNone && std::abs(value) < 1e-18)
               ? 0.0
               : std::abs(value - reference) / std::abs(reference);
}

QuantityErrors errorsOfCurves(const PixelCurve& curve, const PixelCurve& reference) {
    const auto share = [&](MapQuantity quantity) {
        return shareOf(curve.values[quantity], reference.values[quantity]);
    };
    const double off = baseOf(reference.pullOff, reference.retract);
    const double travel = off - reference.retract.front().base;
    QuantityErrors errors;
    errors[JudgedQuantity::PullOffForce] = share(MapQuantity::AdhesionForce);
    errors[JudgedQuantity::PullOffPosition] =
        std::abs(baseOf(curve.pullOff, curve.retract) - off) / travel;
    errors[JudgedQuantity::SnapInForce] =
        shareOf(pullAfterSnapIn(curve), pullAfterSnapIn(reference));
    errors[JudgedQuantity::SnapInPosition] =
        std::abs(baseOf(curve.snapIn, curve.approach) -
                 baseOf(reference.snapIn, reference.approach)) /
        travel;
    errors[JudgedQuantity::Indentation] = share(MapQuantity::Indentation);
    errors[JudgedQuantity::Stiffness] = share(MapQuantity::Stiffness);
    errors[JudgedQuantity::SeparationWork] = shareOf(curve.values[MapQuantity::SeparationWork],
                                                     reference.values[MapQuantity::SeparationWork]);
    errors[JudgedQuantity::RunForce] = rmsOfCurves(curve, reference);
    return errors;
}

/// Shares of the scan's sides, none of them those of a sampled run.
constexpr std::array<std::array<double, 2>, 6> kElsewhere{
    {{0.50, 0.45}, {0.15, 0.80}, {0.85, 0.60}, {0.37, 0.22}, {0.62, 0.71}, {0.90, 0.12}}};

/// What a model says elsewhere.
struct Elsewhere {
    std::vector<PixelCurve> curves;
    std::vector<ModelRun> slides;
};

class OtherRuns {
public:
    explicit OtherRuns(Scene& scene) : scene_(scene) {
        constexpr double kDuration = 0.4;  // [s]
        const Vector2 size(scene.surface.sizeX(), scene.surface.sizeY());
        for (const auto& [x, y] : kElsewhere) {
            positions_.push_back(Vector2(x, y).cwiseProduct(size));
        }
        for (const Vector2& position : std::span(positions_).first(3)) {
            slides_.push_back(recordInputs(scene,
                                           slidePath(scene, {.duration = kDuration,
                                                             .indentation = 2.0_nm,
                                                             .slideLength = 17.0_nm,
                                                             .position = position}),
                                           kDuration));
        }
    }

    [[nodiscard]] Elsewhere of(const ForceModelOptions& model) {
        setModel(scene_, model);
        const MapInstrument instrument(scene_, false);
        Elsewhere result;
        for (const Vector2& position : positions_) {
            result.curves.push_back(pixelCurve(instrument, position, scene_.description.setpoint));
        }
        for (const ModelInputs& slide : slides_) {
            result.slides.push_back(runModel(scene_, {slide}));
        }
        return result;
    }

    [[nodiscard]] QuantityErrors errors(const ForceModelOptions& model,
                                        const ForceModelOptions& reference) {
        const Elsewhere exact = of(reference);
        const Elsewhere found = of(model);
        QuantityErrors errors;
        for (std::size_t i = 0; i < exact.curves.size(); ++i) {
            if (!exact.curves[i].retract.empty() && !found.curves[i].retract.empty()) {
                errors.raiseTo(errorsOfCurves(found.curves[i], exact.curves[i]));
            }
        }
        for (std::size_t i = 0; i < exact.slides.size(); ++i) {
            const double share = forceShare(found.slides[i].states, exact.slides[i].states);
            errors[JudgedQuantity::RunForce] = std::max(errors[JudgedQuantity::RunForce], share);
        }
        return errors;
    }

private:
    Scene& scene_;
    std::vector<Vector2> positions_;
    std::vector<ModelInputs> slides_;
};

}  // namespace

std::vector<StatedErrorScene> statedErrorScenes() {
    return {{"sphere of 100 nm", sphere(100.0_nm)},
            {"sphere of 200 nm", sphere(200.0_nm)},
            {"sphere of 400 nm", sphere(400.0_nm)},
            {"sphere of 800 nm", sphere(800.0_nm)},
            {"sphere of 1,500 nm", sphere(1500.0_nm)},
            {"cylinder of 300 nm",
             sceneOf({.kind = ShapeKind::Cylinder, .radius = 300.0_nm}, siliconOxide())},
            {"sphere of 100 nm as a plane", sphereAsPlane(100.0_nm)},
            {"sphere of 300 nm as a plane", sphereAsPlane(300.0_nm)},
            {"sphere of 1,500 nm as a plane", sphereAsPlane(1500.0_nm)},
            {"plane of 10 degrees", plane(10.0 * kDegree)},
            {"plane of 30 degrees, no torsion", withoutTorsion(plane(30.0 * kDegree))},
            {"plane of 5 degrees, mount of 11 degrees, no tilt",
             withoutTilt(plane(5.0 * kDegree), 11.0 * kDegree)},
            {"film of 20 nm without adhesion", film(20.0_nm, 0.0)},
            {"friction of 0.05 left out", withoutFriction(0.05)},
            {"friction of 0.2 left out", withoutFriction(0.2)}};
}

QuantityErrors trueErrors(Scene& scene, const RequiredTerms& needs) {
    const ForceModelOptions fitted = scene.model;
    ForceModelOptions whole = wholeModel(scene);
    whole.law = needs.full.law;
    setModel(scene, whole);
    OtherRuns runs(scene);
    QuantityErrors law;
    for (const ModelTerm term : missingTerms(whole, scene)) {
        const TermPair pair = pairOf(term, whole);
        law.addSquares(runs.errors(pair.without, pair.with));
    }
    QuantityErrors errors = runs.errors(fitted, whole);
    errors.add(law);
    setModel(scene, fitted);
    return errors;
}

}  // namespace asperity::test
