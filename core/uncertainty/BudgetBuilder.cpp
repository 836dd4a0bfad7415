#include "core/uncertainty/BudgetBuilder.h"

#include "core/uncertainty/ForceBudget.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

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

LandmarkMoves BudgetBuilder::movesBy(const std::function<PlaceNumbers(double sign)>& moved) const {
    const Landmarks up = law_(moved(1.0));
    const Landmarks down = law_(moved(-1.0));
    LandmarkMoves moves{};
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        moves[i] = halfDifference(up[i], down[i], middle_[i]);
    }
    return moves;
}

LandmarkMoves BudgetBuilder::movesTo(const PlaceNumbers& numbers) const {
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

void BudgetBuilder::addFactor(UncertaintyInput input, double PlaceNumbers::*factor,
                              double deviation) {
    if (deviation > 0.0) {
        addBy(input, [&](double sign) {
            PlaceNumbers numbers;
            numbers.*factor = factorOf(sign, deviation);
            return numbers;
        });
    }
}

void BudgetBuilder::takeInstrument() {
    const double own = ownStiffnessDeviation(given_);
    addBy(UncertaintyInput::Stiffness, [own](double sign) {
        const double factor = factorOf(sign, own);
        return PlaceNumbers{.stiffness = factor, .force = factor};
    });
    addBy(UncertaintyInput::InvOls, [this](double sign) {
        const double factor = factorOf(sign, given_.invOls);
        return given_.thermalStiffness
                   ? PlaceNumbers{.stiffness = 1.0 / (factor * factor), .force = 1.0 / factor}
                   : PlaceNumbers{.force = factor};
    });
}

void BudgetBuilder::takeMaterial(bool hasCohesiveRange) {
    addFactor(UncertaintyInput::TipRadius, &PlaceNumbers::tipRadius, given_.tipRadius);
    addFactor(UncertaintyInput::Modulus, &PlaceNumbers::modulus, given_.modulus);
    addFactor(UncertaintyInput::WorkOfAdhesion, &PlaceNumbers::workOfAdhesion,
              given_.workOfAdhesion);
    if (hasCohesiveRange && given_.cohesiveRange > 0.0) {
        addBy(UncertaintyInput::CohesiveRange, [this](double sign) {
            PlaceNumbers numbers;
            numbers.cohesiveRange = factorOf(sign, given_.cohesiveRange);
            return numbers;
        });
    }
}

void BudgetBuilder::takeNormal() {
    for (const Vector2& axis : {Vector2(1.0, 0.0), Vector2(0.0, 1.0)}) {
        addBy(UncertaintyInput::SurfaceNormal, [&](double sign) {
            PlaceNumbers numbers;
            numbers.turn = sign * given_.surfaceNormal * axis;
            return numbers;
        });
    }
}

void BudgetBuilder::takeHeightScales() {
    addFactor(UncertaintyInput::HeightCalibration, &PlaceNumbers::heightScale,
              given_.heightCalibration);
    addFactor(UncertaintyInput::LateralCalibration, &PlaceNumbers::lateralScale,
              given_.lateralCalibration);
}

void BudgetBuilder::takeImagingTip() {
    addFactor(UncertaintyInput::ImagingTip, &PlaceNumbers::imagingTip, given_.imagingTip);
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
        const double shift = budgets_[i].value - middle_[i];
        budgets_[i].shift = std::isfinite(shift) ? shift : 0.0;
    }
}

}  // namespace asperity
