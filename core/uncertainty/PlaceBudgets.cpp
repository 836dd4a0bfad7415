#include "core/uncertainty/PlaceBudgets.h"

#include "core/scene/ScanSmoothing.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/ContactHeight.h"
#include "core/uncertainty/BudgetBuilder.h"
#include "core/uncertainty/FitResponse.h"
#include "core/uncertainty/PlaceLaw.h"
#include "core/uncertainty/RecordedScan.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace asperity {

namespace {

/// Columns whose products with themselves add up to a covariance.
ReliefCovariance rootOf(const ReliefCovariance& covariance) {
    const Eigen::LDLT<ReliefCovariance> parts(covariance);
    const Relief lengths = parts.vectorD().cwiseMax(0.0).cwiseSqrt();
    const ReliefCovariance lower = parts.matrixL();
    return parts.transpositionsP().transpose() * (lower * lengths.asDiagonal());
}

/// What the heights of a scan leave open at a place where it was recorded: before any erosion,
/// which then makes of each move what it makes of the surface.
class HeightShares {
public:
    HeightShares(const Scene& scene, const RecordedScan& scan, const Vector2& place,
                 BudgetBuilder& builder)
        : builder_(builder)
        , smoothing_(smoothingOf(scene.description.sample, scene.surface.grid()))
        , pitchX_(scan.grid().pitchX)
        , pitchY_(scan.grid().pitchY)
        , response_(scan, smoothing_, place.x(), place.y())
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
                [&part](double sign) { return PlaceNumbers{.relief = sign * part}; });
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
PlaceBudgets withLeftOut(PlaceBudgets budgets, const std::optional<QuantityErrors>& errors) {
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
PlaceBudgets ofSeveralContacts(PlaceBudgets budgets) {
    for (const LandmarkRow& row : kEnumTable<Landmark>) {
        Budget& budget = budgets[static_cast<std::size_t>(row.value)];
        if (row.value != Landmark::NormalForce) {
            budget = budget.withoutShares(UnknownShares::SeveralContacts);
        }
    }
    return budgets;
}

}  // namespace

double usedHeightNoise(const Scene& scene) noexcept {
    const double given = scene.description.uncertainty.heightNoise;
    return given > 0.0 ? given : scene.heightNoise;
}

PlaceBudgets budgetsAt(const Scene& scene, const TipState& state, double force) {
    const RecordedScan scan(scene);
    const RecordedPlaces places = recordedPlaces(scene, state);
    const PlaceLaw law(scene, state, scan, places, force);
    const Uncertainty& given = scene.description.uncertainty;
    BudgetBuilder builder(
        given, [&law](const PlaceNumbers& numbers) { return law.at(numbers); }, law.shown());
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
        HeightShares(scene, scan, places.touched, builder).take();
    }
    return withLeftOut(builder.budgets(), scene.leftOut);
}

PlaceBudgets budgetsAt(const Scene& scene, const Vector2& place, double force) {
    const double radius = scene.belief.tipRadius();
    const double height =
        scene.shape ? scene.surface.at(place.x(), place.y()).height
                    : tipContactHeight(scene.surface, place.x(), place.y(), radius) - radius;
    const BaseMotion tip{.position = Vector3(place.x(), place.y(), height)};
    return budgetsAt(scene, heldTip(scene.believedSurface(), scene.belief, tip, {}), force);
}

PlaceBudgets budgetsOf(const SceneDescription& scene, const ContactModel& model, double compliance,
                       double force) {
    const auto law = [&](const PlaceNumbers& numbers) {
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

}  // namespace asperity
