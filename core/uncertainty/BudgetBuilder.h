#pragma once

#include "core/uncertainty/PlaceBudgets.h"
#include "core/uncertainty/PlaceNumbers.h"

#include <array>
#include <functional>
#include <optional>

namespace asperity {

/// Landmarks of a law as a function of what they depend on.
using LandmarkLaw = std::function<Landmarks(const PlaceNumbers&)>;

/// By how much each landmark moves, in the order of Landmark.
using LandmarkMoves = std::array<double, kLandmarkCount>;

/// Fills the budgets of one law, input by input.
class BudgetBuilder {
public:
    /// @param shown landmarks that a scene shows; none: those of the law as it is
    BudgetBuilder(const Uncertainty& given, LandmarkLaw law,
                  const std::optional<Landmarks>& shown = std::nullopt);

    [[nodiscard]] const PlaceBudgets& budgets() const noexcept { return budgets_; }

    /// Half the difference between the inputs one deviation above and below.
    /// @param moved numbers for +1 and for -1
    [[nodiscard]] LandmarkMoves
    movesBy(const std::function<PlaceNumbers(double sign)>& moved) const;
    /// From the law as it is to that of other numbers; where there is no such landmark then, all of
    /// it.
    [[nodiscard]] LandmarkMoves movesTo(const PlaceNumbers& numbers) const;
    /// Adds moves to those of an input, by their squares.
    void add(UncertaintyInput input, const LandmarkMoves& moves);
    /// Takes moves that noise hides, the larger ones, see Budget::hidden.
    void hide(const LandmarkMoves& moves);

    /// The setpoint is one of deflection: the force there goes as k and InvOLS. A k by thermal
    /// spectrum goes as 1 / InvOLS^2; that part of it is InvOLS's own.
    void takeInstrument();
    /// @param hasCohesiveRange whether the law has a range h0 of its own
    void takeMaterial(bool hasCohesiveRange);
    void takeNormal();
    void takeHeightScales();
    /// The radius of the imaging tip, and what a scene shows because it has not taken it out.
    void takeImagingTip();

private:
    void addBy(UncertaintyInput input, const std::function<PlaceNumbers(double sign)>& moved) {
        add(input, movesBy(moved));
    }
    /// One factor of the numbers with a relative deviation.
    void addFactor(UncertaintyInput input, double PlaceNumbers::*factor, double deviation);

    Uncertainty given_;
    LandmarkLaw law_;
    Landmarks middle_;
    PlaceBudgets budgets_;
};

}  // namespace asperity
