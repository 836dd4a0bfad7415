#include "core/uncertainty/PlaceBudgets.h"

#include "core/scene/ScanSmoothing.h"
#include "core/uncertainty/PlaceLaw.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

using Deviations = std::array<double, kLandmarkCount>;

/// By how much a landmark differs; where one side has none, the way to the other, where none has
/// one, all of it.
double halfDifference(double up, double down, double middle) {
    if (std::isfinite(up) && std::isfinite(down)) {
        return 0.5 * (up - down);
    }
    if (!std::isfinite(middle)) {
        return 0.0;
    }
    const double one = std::isfinite(up) ? up - middle : middle - down;
    return std::isfinite(one) ? one : middle;
}

/// Columns whose products with themselves add up to a covariance.
ReliefCovariance rootOf(const ReliefCovariance& covariance) {
    const Eigen::LDLT<ReliefCovariance> parts(covariance);
    const Relief lengths = parts.vectorD().cwiseMax(0.0).cwiseSqrt();
    const ReliefCovariance lower = parts.matrixL();
    return parts.transpositionsP().transpose() * (lower * lengths.asDiagonal());
}

/// Fills the budgets of one place, input by input.
class BudgetBuilder {
public:
    BudgetBuilder(const Scene& scene, const TipState& state, double force)
        : scene_(scene)
        , given_(scene.description.uncertainty)
        , place_(state.closest.point.head<2>())
        , law_(scene, state, force)
        , middle_(law_.at({})) {}

    [[nodiscard]] PlaceBudgets build() {
        for (std::size_t i = 0; i < kLandmarkCount; ++i) {
            budgets_[i].value = middle_[i];
        }
        if (given_.enabled) {
            takeInstrument();
            takeMaterial();
            takeNormal();
            if (!scene_.shape) {
                takeHeights();
            }
        }
        return budgets_;
    }

private:
    /// Adds the difference between the inputs one deviation above and below, by the square.
    /// @param moved numbers for +1 and for -1
    template <class Moved>
    void add(UncertaintyInput input, const Moved& moved) {
        addDeviation(input, deviationBy(moved));
    }

    template <class Moved>
    [[nodiscard]] Deviations deviationBy(const Moved& moved) const {
        const Landmarks up = law_.at(moved(1.0));
        const Landmarks down = law_.at(moved(-1.0));
        Deviations deviations{};
        for (std::size_t i = 0; i < kLandmarkCount; ++i) {
            deviations[i] = halfDifference(up[i], down[i], middle_[i]);
        }
        return deviations;
    }

    void addDeviation(UncertaintyInput input, const Deviations& deviations) {
        for (std::size_t i = 0; i < kLandmarkCount; ++i) {
            double& share = budgets_[i].shares[static_cast<std::size_t>(input)];
            share = std::hypot(share, deviations[i]);
        }
    }

    /// One factor of the numbers with a relative deviation.
    void addFactor(UncertaintyInput input, double PlaceNumbers::*factor, double deviation) {
        if (deviation > 0.0) {
            add(input, [&](double sign) {
                PlaceNumbers numbers;
                numbers.*factor = factorOf(sign, deviation);
                return numbers;
            });
        }
    }

    /// Never 0 or less, however large the deviation is.
    [[nodiscard]] static double factorOf(double sign, double deviation) {
        return sign > 0.0 ? 1.0 + deviation : 1.0 / (1.0 + deviation);
    }

    /// The setpoint is one of deflection: the force there goes as k and InvOLS. A k by thermal
    /// spectrum goes as 1 / InvOLS^2; that part of it is InvOLS's own.
    void takeInstrument() {
        const double common = given_.thermalStiffness ? 2.0 * given_.invOls : 0.0;
        const double own =
            std::sqrt(std::max(0.0, (given_.stiffness * given_.stiffness) - (common * common)));
        add(UncertaintyInput::Stiffness, [own](double sign) {
            const double factor = factorOf(sign, own);
            return PlaceNumbers{.stiffness = factor, .force = factor};
        });
        add(UncertaintyInput::InvOls, [this](double sign) {
            const double factor = factorOf(sign, given_.invOls);
            return given_.thermalStiffness
                       ? PlaceNumbers{.stiffness = 1.0 / (factor * factor), .force = 1.0 / factor}
                       : PlaceNumbers{.force = factor};
        });
    }

    void takeMaterial() {
        addFactor(UncertaintyInput::TipRadius, &PlaceNumbers::tipRadius, given_.tipRadius);
        addFactor(UncertaintyInput::Modulus, &PlaceNumbers::modulus, given_.modulus);
        addFactor(UncertaintyInput::WorkOfAdhesion, &PlaceNumbers::workOfAdhesion,
                  given_.workOfAdhesion);
        if (law_.hasCohesiveRange() && given_.cohesiveRange > 0.0) {
            add(UncertaintyInput::CohesiveRange, [this](double sign) {
                PlaceNumbers numbers;
                numbers.cohesiveRange = factorOf(sign, given_.cohesiveRange);
                return numbers;
            });
        }
    }

    void takeNormal() {
        for (const Vector2& axis : {Vector2(1.0, 0.0), Vector2(0.0, 1.0)}) {
            add(UncertaintyInput::SurfaceNormal, [&](double sign) {
                PlaceNumbers numbers;
                numbers.turn = sign * given_.surfaceNormal * axis;
                return numbers;
            });
        }
    }

    void takeHeights() {
        addFactor(UncertaintyInput::HeightCalibration, &PlaceNumbers::heightScale,
                  given_.heightCalibration);
        addFactor(UncertaintyInput::LateralCalibration, &PlaceNumbers::lateralScale,
                  given_.lateralCalibration);
        const BSplineSurface& surface = scene_.surface;
        const Smoothing smoothing = smoothingOf(scene_.description.sample, surface.grid());
        const FitResponse response(surface, smoothing, place_.x(), place_.y());
        const double noise = usedHeightNoise(scene_);
        for (const Deviations& deviation : byRelief(noise * rootOf(response.noise()))) {
            addDeviation(UncertaintyInput::HeightNoise, deviation);
        }
        const double x = surface.grid().pitchX;
        const double y = surface.grid().pitchY;
        const double sigmaX = smoothing.x * x;
        const double sigmaY = smoothing.y * y;
        takeBlur(UncertaintyInput::Smoothing, response, {sigmaX * sigmaX, sigmaY * sigmaY});
        takeBlur(UncertaintyInput::Pixels, response, {x * x / 12.0, y * y / 12.0});
    }

    [[nodiscard]] std::vector<Deviations> byRelief(const ReliefCovariance& root) const {
        std::vector<Deviations> deviations;
        for (int column = 0; column < root.cols(); ++column) {
            const Relief part = root.col(column);
            deviations.push_back(
                deviationBy([&part](double sign) { return PlaceNumbers{.relief = sign * part}; }));
        }
        return deviations;
    }

    /// What a blur moved, less what noise alone lets it seem.
    void takeBlur(UncertaintyInput input, const FitResponse& response, const BlurWidth& blur) {
        const Relief sharper = response.sharpening(blur);
        const Landmarks sharp = law_.at({.relief = sharper});
        const ReliefCovariance root =
            usedHeightNoise(scene_) * rootOf(response.sharpeningNoise(blur));
        Deviations seeming{};
        for (const Deviations& deviation : byRelief(root)) {
            for (std::size_t i = 0; i < kLandmarkCount; ++i) {
                seeming[i] = std::hypot(seeming[i], deviation[i]);
            }
        }
        Deviations moved{};
        for (std::size_t i = 0; i < kLandmarkCount; ++i) {
            const double moves = sharp[i] - middle_[i];
            const double all = std::isfinite(middle_[i]) ? middle_[i] : 0.0;
            const double shift = std::abs(std::isfinite(moves) ? moves : all);
            moved[i] =
                shift > seeming[i] ? std::sqrt((shift - seeming[i]) * (shift + seeming[i])) : 0.0;
        }
        addDeviation(input, moved);
    }

    const Scene& scene_;
    const Uncertainty& given_;
    Vector2 place_;
    PlaceLaw law_;
    Landmarks middle_;
    PlaceBudgets budgets_;
};

}  // namespace

double usedHeightNoise(const Scene& scene) noexcept {
    const double given = scene.description.uncertainty.heightNoise;
    return given > 0.0 ? given : scene.heightNoise;
}

PlaceBudgets budgetsAt(const Scene& scene, const TipState& state, double force) {
    return BudgetBuilder(scene, state, force).build();
}

PlaceBudgets budgetsAt(const Scene& scene, const Vector2& place, double force) {
    const double height = scene.surface.at(place.x(), place.y()).height;
    const BaseMotion tip{.position = Vector3(place.x(), place.y(), height)};
    return budgetsAt(scene, heldTip(scene.believedSurface(), scene.belief, tip, {}), force);
}

}  // namespace asperity
