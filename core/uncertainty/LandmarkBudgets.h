#pragma once

#include "core/Vector.h"
#include "core/contact/laws/ContactModel.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/SceneDescription.h"
#include "core/uncertainty/Budget.h"
#include "core/uncertainty/FitResponse.h"
#include "core/uncertainty/Landmarks.h"

#include <array>
#include <functional>
#include <optional>

namespace asperity {

/// Numbers that the landmarks of a position depend on, relative to what the scene says.
struct LawNumbers {
    double stiffness = 1.0;
    double force = 1.0;  ///< normal force at the setpoint per force that the signals show
    double tipRadius = 1.0;
    double modulus = 1.0;
    double workOfAdhesion = 1.0;
    double heightScale = 1.0;
    double lateralScale = 1.0;
    /// Radius of the imaging tip that is taken out of the scan, where the scene says one; 0: the
    /// scan as it was recorded.
    double imagingTip = 1.0;
    Relief relief = Relief::Zero();  ///< to be added to that of the recorded scan at the position
    Vector2 turn = Vector2::Zero();  ///< of the normal about two axes along the surface [rad]
    std::optional<double> cohesiveRange = std::nullopt;  ///< none: the scene's
};

/// Returns whether a law has a range h0 of its own.
[[nodiscard]] bool hasCohesiveRange(const ContactModel& model) noexcept;

/// The law of a contact with other numbers of its material; the pair's radius is taken as it is.
/// @param model law and options @param pair of the contact, as the scene says
[[nodiscard]] ContactModel withNumbers(const SceneDescription& scene, const ContactModel& model,
                                       ContactPair pair, const LawNumbers& numbers);

struct Scene;
struct SceneDescription;
struct TipState;

/// Budgets in the order of Landmark; the value is NaN where there is no such landmark.
using LandmarkBudgets = std::array<Budget, kLandmarkCount>;

[[nodiscard]] inline const Budget& budgetOf(const LandmarkBudgets& budgets,
                                            Landmark landmark) noexcept {
    return budgets[static_cast<std::size_t>(landmark)];
}

/// Computes by what each input of [uncertainty] moves the landmarks of the believed contact at one
/// position, from the contact law alone: no cycle is repeated. Noise is 0: it is of a reading. All
/// shares are 0 where the scene has `enabled = false`, and but for those of the setpoint's force
/// not known where the tip has several contacts: the law is of one. Nor are they where the scene
/// shows a landmark that the law without the imaging tip does not have. Some 40 evaluations of the
/// law, of fold, equilibrium and area each.
/// @param state of the believed tip at the position
/// @param force along the normal at the setpoint [N]; not above 0: there is none
/// Source: docs/uncertainty.md.
[[nodiscard]] LandmarkBudgets budgetsAt(const Scene& scene, const TipState& state, double force);

/// The same where the tip first touches the sample as it comes down at a position: a blunt one
/// beside it. @param position of the apex, world x, y [m]
[[nodiscard]] LandmarkBudgets budgetsAt(const Scene& scene, const Vector2& position, double force);

/// Computes the budgets of a contact law that has no position: of a flat sample and a lever whose
/// compliance along the normal is given. No heights and no normal move it.
/// @param scene whose deviations, tip and sample the law has @param compliance [m/N]
/// @param force as above
[[nodiscard]] LandmarkBudgets budgetsOf(const SceneDescription& scene, const ContactModel& model,
                                        double compliance, double force);

/// White noise of the scan's heights as the budgets take it: the scene's, or the estimate [m].
[[nodiscard]] double usedHeightNoise(const Scene& scene) noexcept;

/// The contact law of one position as a function of what it depends on. The scene must outlive it.
class LocalLaw {
public:
    /// @param state of the believed tip at the position
    /// @param scan as it was recorded; a shape has none that counts
    /// @param positions of the state in the scan
    /// @param force along the normal at the setpoint [N]; not above 0: there is none
    LocalLaw(const Scene& scene, const TipState& state, const RecordedScan& scan,
             const RecordedPositions& positions, double force);

    /// Returns the landmarks on the surface without its imaging tip.
    [[nodiscard]] Landmarks at(const LawNumbers& numbers) const;
    /// Returns the landmarks on the surface that the scene shows: of a scan that is not eroded,
    /// with its imaging tip's shape.
    [[nodiscard]] Landmarks shown() const;

private:
    [[nodiscard]] double radiusOf(const Relief& relief, const LawNumbers& numbers) const noexcept;
    [[nodiscard]] double complianceOf(const Relief& relief,
                                      const LawNumbers& numbers) const noexcept;
    /// The attraction beside the contact goes as the half-space's, H R / (6 g^2).
    [[nodiscard]] BodyPull bodyWith(const LawNumbers& numbers) const noexcept;
    [[nodiscard]] Landmarks at(const Relief& relief, const LawNumbers& numbers) const;

    const Scene& scene_;
    TipState state_;
    Relief shown_;    ///< of the recorded scan
    Relief touched_;  ///< of it where the tip touches the surface without its imaging tip
    double force_;
};

/// Landmarks of a law as a function of what they depend on.
using LandmarkLaw = std::function<Landmarks(const LawNumbers&)>;

/// Displacement of each landmark, in the order of Landmark.
using LandmarkMoves = std::array<double, kLandmarkCount>;

/// Fills the budgets of one law, input by input.
class BudgetBuilder {
public:
    /// @param shown landmarks that a scene shows; none: those of the law as it is
    BudgetBuilder(const Uncertainty& given, LandmarkLaw law,
                  const std::optional<Landmarks>& shown = std::nullopt);

    [[nodiscard]] const LandmarkBudgets& budgets() const noexcept { return budgets_; }

    /// Half the difference between the inputs one deviation above and below.
    /// @param moved numbers for +1 and for -1
    [[nodiscard]] LandmarkMoves movesBy(const std::function<LawNumbers(double sign)>& moved) const;
    /// Returns the moves from the law as it is to that of other numbers; where there is no such
    /// landmark then, all of it.
    [[nodiscard]] LandmarkMoves movesTo(const LawNumbers& numbers) const;
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
    void addBy(UncertaintyInput input, const std::function<LawNumbers(double sign)>& moved) {
        add(input, movesBy(moved));
    }
    /// One factor of the numbers with a relative deviation.
    void addFactor(UncertaintyInput input, double LawNumbers::*factor, double deviation);

    Uncertainty given_;
    LandmarkLaw law_;
    Landmarks middle_;
    LandmarkBudgets budgets_;
};

}  // namespace asperity
