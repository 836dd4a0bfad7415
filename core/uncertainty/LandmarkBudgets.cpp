#include "core/uncertainty/LandmarkBudgets.h"

#include "core/contact/ContactState.h"
#include "core/scene/ScanSmoothing.h"
#include "core/scene/Scene.h"
#include "core/surface/Curvature.h"
#include "core/surface/deformation/ContactHeight.h"
#include "core/uncertainty/CycleBudgets.h"
#include "core/uncertainty/FitResponse.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

ContactModel withCohesiveRange(const SceneDescription& scene, const ContactModel& model,
                               const LawNumbers& numbers) {
    if (!numbers.cohesiveRange) {
        return model;
    }
    ContactOptions options = contactOptions(scene, scene.sample.material);
    options.cohesiveStress /= *numbers.cohesiveRange;
    options.solver = SolverSetting::Exact;
    return ContactModel(model.law(), model.pair(), options);
}

/// Columns whose products with themselves add up to a covariance.
ReliefCovariance rootOf(const ReliefCovariance& covariance) {
    const Eigen::LDLT<ReliefCovariance> parts(covariance);
    const Relief lengths = parts.vectorD().cwiseMax(0.0).cwiseSqrt();
    const ReliefCovariance lower = parts.matrixL();
    return parts.transpositionsP().transpose() * (lower * lengths.asDiagonal());
}

/// Uncertainty left by the heights of a scan at a position where it was recorded: before any
/// erosion, which then makes of each move what it makes of the surface.
class HeightShares {
public:
    HeightShares(const Scene& scene, const RecordedScan& scan, const Vector2& position,
                 BudgetBuilder& builder)
        : builder_(builder)
        , smoothing_(smoothingOf(scene.description.sample, scene.surface.grid()))
        , pitchX_(scan.grid().pitchX)
        , pitchY_(scan.grid().pitchY)
        , response_(scan, smoothing_, position.x(), position.y())
        , noise_(usedHeightNoise(scene)) {}

    void take() {
        builder_.takeHeightScales();
        builder_.add(UncertaintyInput::HeightNoise, movesOf(response_.noise()));
        const double sigmaX = smoothing_.x * pitchX_;
        const double sigmaY = smoothing_.y * pitchY_;
        takeBlur(UncertaintyInput::Smoothing, {sigmaX * sigmaX, sigmaY * sigmaY});
        takeBlur(UncertaintyInput::Pixels, {pitchX_ * pitchX_ / 12.0, pitchY_ * pitchY_ / 12.0});
    }

private:
    /// @param covariance of the derivatives by noise of 1 m
    [[nodiscard]] LandmarkMoves movesOf(const ReliefCovariance& covariance) const {
        const ReliefCovariance root = noise_ * rootOf(covariance);
        LandmarkMoves all{};
        for (int column = 0; column < root.cols(); ++column) {
            const Relief part = root.col(column);
            const LandmarkMoves moves = builder_.movesBy(
                [&part](double sign) { return LawNumbers{.relief = sign * part}; });
            for (std::size_t i = 0; i < kLandmarkCount; ++i) {
                all[i] = std::hypot(all[i], moves[i]);
            }
        }
        return all;
    }

    /// Adds the effect of a blur, less the effect that noise alone would show. Roughness of the
    /// latter size may be hidden, however large the blur's effect is.
    void takeBlur(UncertaintyInput input, const BlurWidth& blur) {
        const LandmarkMoves seeming = movesOf(response_.sharpeningNoise(blur));
        LandmarkMoves moves = builder_.movesTo({.relief = response_.sharpening(blur)});
        for (std::size_t i = 0; i < kLandmarkCount; ++i) {
            const double shift = std::abs(moves[i]);
            moves[i] =
                shift > seeming[i] ? std::sqrt((shift - seeming[i]) * (shift + seeming[i])) : 0.0;
        }
        builder_.add(input, moves);
        builder_.hide(seeming);
    }

    BudgetBuilder& builder_;
    Smoothing smoothing_;
    double pitchX_;  ///< [m]
    double pitchY_;
    FitResponse response_;
    double noise_;  ///< of the heights [m]
};

/// A position's error is a share of the base's travel, see QuantityErrors.
bool isPosition(JudgedQuantity quantity) noexcept {
    return quantity == JudgedQuantity::SnapInPosition ||
           quantity == JudgedQuantity::PullOffPosition;
}

/// @param errors none: not judged
LandmarkBudgets withLeftOut(LandmarkBudgets budgets, const std::optional<QuantityErrors>& errors) {
    const double travel = budgetOf(budgets, Landmark::ContactTravel).value;
    for (const LandmarkRow& row : kEnumTable<Landmark>) {
        Budget& budget = budgets[static_cast<std::size_t>(row.value)];
        if (row.judged && std::isfinite(budget.value)) {
            const double whole = isPosition(*row.judged) ? travel : budget.value;
            budget.leftOut = errors ? std::abs(whole) * (*errors)[*row.judged] : 0.0;
            budget.isLeftOutJudged = errors.has_value();
        }
    }
    return budgets;
}

/// The law is of one contact; the force that the lever holds is that of all.
LandmarkBudgets ofSeveralContacts(LandmarkBudgets budgets) {
    for (const LandmarkRow& row : kEnumTable<Landmark>) {
        Budget& budget = budgets[static_cast<std::size_t>(row.value)];
        if (row.value != Landmark::NormalForce) {
            budget = budget.withoutShares(UnknownShares::SeveralContacts);
        }
    }
    return budgets;
}

/// A surface lies inside the scan of it as a parallel surface does: its radii of curvature are less
/// by that of the tip.
double withoutTip(double curvature, double tip) noexcept {
    constexpr double kMin = 0.1;  // what a scan shows sharper than its own tip is noise
    return curvature / std::max(1.0 - (tip * curvature), kMin);
}

/// The recorded relief under other calibrations and moves.
Relief movedBy(const LawNumbers& numbers, const Relief& relief) noexcept {
    const double slope = numbers.heightScale / numbers.lateralScale;
    Relief scale;
    scale << slope, slope, Eigen::Vector3d::Constant(slope / numbers.lateralScale);
    return relief.cwiseProduct(scale) + numbers.relief;
}

/// Those with which the law is that of the surface that a scene shows.
LawNumbers shownNumbers(const Scene& scene) noexcept {
    return {.imagingTip = scene.description.sample.erode ? 1.0 : 0.0};
}

/// By how much a landmark differs; where one side has none, the way to the other, where none has
/// one, all of it.
double halfDifference(double up, double down, double middle) {
    constexpr double kRounding = 1e-12;  // of the landmark: less is no move
    if (std::isfinite(up) && std::isfinite(down)) {
        const double half = 0.5 * (up - down);
        return std::abs(half) > kRounding * std::abs(middle) ? half : 0.0;
    }
    if (!std::isfinite(middle)) {
        return 0.0;
    }
    const double one = std::isfinite(up) ? up - middle : middle - down;
    return std::isfinite(one) ? one : middle;
}

/// Never 0 or less, however large the deviation is.
double factorOf(double sign, double deviation) {
    return sign > 0.0 ? 1.0 + deviation : 1.0 / (1.0 + deviation);
}

}  // namespace

bool hasCohesiveRange(const ContactModel& model) noexcept {
    const LawTraits& law = traitsOf(model.law());
    return law.attraction == Attraction::Zone && !law.tail;
}

ContactModel withNumbers(const SceneDescription& scene, const ContactModel& model, ContactPair pair,
                         const LawNumbers& numbers) {
    const Elastic& tip = scene.tip.elastic;
    const Elastic& sample = scene.sample.material.elastic;
    Elastic moved = sample;
    moved.youngsModulus *= numbers.modulus;
    pair.reducedModulus *= reducedModulus(moved, tip) / reducedModulus(sample, tip);
    pair.workOfAdhesion *= numbers.workOfAdhesion;
    return withCohesiveRange(scene, model, numbers).withPair(pair);
}

double usedHeightNoise(const Scene& scene) noexcept {
    const double given = scene.description.uncertainty.heightNoise;
    return given > 0.0 ? given : scene.heightNoise;
}

LandmarkBudgets budgetsAt(const Scene& scene, const TipState& state, double force) {
    const RecordedScan scan(scene);
    const RecordedPositions positions = recordedPositions(scene, state);
    const LocalLaw law(scene, state, scan, positions, force);
    const Uncertainty& given = scene.description.uncertainty;
    BudgetBuilder builder(
        given, [&law](const LawNumbers& numbers) { return law.at(numbers); }, law.shown());
    if (!given.enabled) {
        return builder.budgets();
    }
    builder.takeInstrument();
    if (state.points > 1) {
        return withLeftOut(ofSeveralContacts(builder.budgets()), scene.leftOut);
    }
    builder.takeMaterial(hasCohesiveRange(scene.belief.contact));
    builder.takeNormal();
    if (!scene.shape) {
        if (scene.description.sample.imagingTipRadius > 0.0) {
            builder.takeImagingTip();
        }
        HeightShares(scene, scan, positions.touched, builder).take();
    }
    return withLeftOut(builder.budgets(), scene.leftOut);
}

LandmarkBudgets budgetsAt(const Scene& scene, const Vector2& position, double force) {
    const double radius = scene.belief.tipRadius();
    const double height =
        scene.shape ? scene.surface.at(position.x(), position.y()).height
                    : tipContactHeight(scene.surface, position.x(), position.y(), radius) - radius;
    const BaseMotion tip{.position = Vector3(position.x(), position.y(), height)};
    return budgetsAt(scene, heldTip(scene.believedSurface(), scene.belief, tip, {}), force);
}

LandmarkBudgets budgetsOf(const SceneDescription& scene, const ContactModel& model,
                          double compliance, double force) {
    const auto law = [&](const LawNumbers& numbers) {
        ContactPair pair = model.pair();
        pair.tipRadius *= numbers.tipRadius;
        return landmarksOf(withNumbers(scene, model, pair, numbers), compliance / numbers.stiffness,
                           force * numbers.force);
    };
    BudgetBuilder builder(scene.uncertainty, law);
    if (scene.uncertainty.enabled) {
        builder.takeInstrument();
        builder.takeMaterial(hasCohesiveRange(model));
    }
    return builder.budgets();
}

LocalLaw::LocalLaw(const Scene& scene, const TipState& state, const RecordedScan& scan,
                   const RecordedPositions& positions, double force)
    : scene_(scene)
    , state_(state)
    , shown_(scan.reliefAt(positions.shown.x(), positions.shown.y()))
    , touched_(scan.reliefAt(positions.touched.x(), positions.touched.y()))
    , force_(force) {}

double LocalLaw::radiusOf(const Relief& relief, const LawNumbers& numbers) const noexcept {
    const ProbeSystem& system = scene_.belief;
    const double tip = system.tipRadius() * numbers.tipRadius;
    if (!system.curvature || isSphere(system.contact.law())) {
        return tip;
    }
    if (scene_.shape) {
        const PrincipalCurvatures& bend = state_.closest.curvatures;
        return effectiveRadius(tip, bend.largest, bend.smallest).radius;
    }
    const PrincipalCurvatures bend = principalCurvatures(sampleOf(relief));
    const double imagingTip = scene_.description.sample.imagingTipRadius * numbers.imagingTip;
    return effectiveRadius(tip, withoutTip(bend.largest, imagingTip),
                           withoutTip(bend.smallest, imagingTip))
        .radius;
}

double LocalLaw::complianceOf(const Relief& relief, const LawNumbers& numbers) const noexcept {
    Vector3 normal = scene_.shape ? state_.closest.normal : sampleOf(relief).normal();
    const Vector3 first = normal.cross(Vector3::UnitX()).normalized();
    normal = (normal + (numbers.turn.x() * first) + (numbers.turn.y() * first.cross(normal)))
                 .normalized();
    return normal.dot(scene_.belief.cantilever.compliance() * normal) / numbers.stiffness;
}

BodyPull LocalLaw::bodyWith(const LawNumbers& numbers) const noexcept {
    const double factor = numbers.workOfAdhesion * numbers.tipRadius;
    return {.force = factor * state_.body.force, .slope = factor * state_.body.slope};
}

Landmarks LocalLaw::at(const Relief& relief, const LawNumbers& numbers) const {
    const Relief moved = movedBy(numbers, relief);
    const double radius =
        state_.effectiveRadius * radiusOf(moved, numbers) / radiusOf(shown_, shownNumbers(scene_));
    const ContactPair pair = scene_.belief.pairAt(state_.closest.point, radius);
    ContactModel law = withNumbers(scene_.description, scene_.belief.contact, pair, numbers);
    law.setBodyPull(bodyWith(numbers));
    return landmarksOf(law, complianceOf(moved, numbers), force_ * numbers.force);
}

Landmarks LocalLaw::at(const LawNumbers& numbers) const { return at(touched_, numbers); }

Landmarks LocalLaw::shown() const { return at(shown_, shownNumbers(scene_)); }

BudgetBuilder::BudgetBuilder(const Uncertainty& given, LandmarkLaw law,
                             const std::optional<Landmarks>& shown)
    : given_(given), law_(std::move(law)), middle_(law_({})) {
    const Landmarks& values = shown ? *shown : middle_;
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        budgets_[i].value = values[i];
        // Moves of a landmark that the law does not have would be 0, and are not.
        if (given_.enabled && std::isfinite(values[i]) && !std::isfinite(middle_[i])) {
            budgets_[i] = budgets_[i].withoutShares(UnknownShares::NoLandmark);
        }
    }
}

LandmarkMoves BudgetBuilder::movesBy(const std::function<LawNumbers(double sign)>& moved) const {
    const Landmarks up = law_(moved(1.0));
    const Landmarks down = law_(moved(-1.0));
    LandmarkMoves moves{};
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        moves[i] = halfDifference(up[i], down[i], middle_[i]);
    }
    return moves;
}

LandmarkMoves BudgetBuilder::movesTo(const LawNumbers& numbers) const {
    const Landmarks other = law_(numbers);
    LandmarkMoves moves{};
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        const double move = other[i] - middle_[i];
        const double all = std::isfinite(middle_[i]) ? middle_[i] : 0.0;
        moves[i] = std::isfinite(move) ? move : all;
    }
    return moves;
}

void BudgetBuilder::add(UncertaintyInput input, const LandmarkMoves& moves) {
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        double& share = budgets_[i].shares[static_cast<std::size_t>(input)];
        share = std::hypot(share, moves[i]);
    }
}

void BudgetBuilder::hide(const LandmarkMoves& moves) {
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        budgets_[i].hidden = std::max(budgets_[i].hidden, moves[i]);
    }
}

void BudgetBuilder::addFactor(UncertaintyInput input, double LawNumbers::*factor,
                              double deviation) {
    if (deviation > 0.0) {
        addBy(input, [&](double sign) {
            LawNumbers numbers;
            numbers.*factor = factorOf(sign, deviation);
            return numbers;
        });
    }
}

void BudgetBuilder::takeInstrument() {
    const double own = ownStiffnessDeviation(given_);
    addBy(UncertaintyInput::Stiffness, [own](double sign) {
        const double factor = factorOf(sign, own);
        return LawNumbers{.stiffness = factor, .force = factor};
    });
    addBy(UncertaintyInput::InvOls, [this](double sign) {
        const double factor = factorOf(sign, given_.invOls);
        return given_.thermalStiffness
                   ? LawNumbers{.stiffness = 1.0 / (factor * factor), .force = 1.0 / factor}
                   : LawNumbers{.force = factor};
    });
}

void BudgetBuilder::takeMaterial(bool hasCohesiveRange) {
    addFactor(UncertaintyInput::TipRadius, &LawNumbers::tipRadius, given_.tipRadius);
    addFactor(UncertaintyInput::Modulus, &LawNumbers::modulus, given_.modulus);
    addFactor(UncertaintyInput::WorkOfAdhesion, &LawNumbers::workOfAdhesion, given_.workOfAdhesion);
    if (hasCohesiveRange && given_.cohesiveRange > 0.0) {
        addBy(UncertaintyInput::CohesiveRange, [this](double sign) {
            LawNumbers numbers;
            numbers.cohesiveRange = factorOf(sign, given_.cohesiveRange);
            return numbers;
        });
    }
}

void BudgetBuilder::takeNormal() {
    for (const Vector2& axis : {Vector2(1.0, 0.0), Vector2(0.0, 1.0)}) {
        addBy(UncertaintyInput::SurfaceNormal, [&](double sign) {
            LawNumbers numbers;
            numbers.turn = sign * given_.surfaceNormal * axis;
            return numbers;
        });
    }
}

void BudgetBuilder::takeHeightScales() {
    addFactor(UncertaintyInput::HeightCalibration, &LawNumbers::heightScale,
              given_.heightCalibration);
    addFactor(UncertaintyInput::LateralCalibration, &LawNumbers::lateralScale,
              given_.lateralCalibration);
}

void BudgetBuilder::takeImagingTip() {
    addFactor(UncertaintyInput::ImagingTip, &LawNumbers::imagingTip, given_.imagingTip);
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        const double shift = budgets_[i].value - middle_[i];
        budgets_[i].shift = std::isfinite(shift) ? shift : 0.0;
    }
}

}  // namespace asperity
