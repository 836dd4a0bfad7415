#pragma once

#include "core/scene/ForceModelOptions.h"

#include <cstdint>
#include <optional>

namespace asperity {

enum class ModelTerm : std::uint8_t;

/// The choices of a scene for its model. What it leaves open is as it requires, see fitModel(); its
/// law, see chooseLaw().
struct ModelChoices {
    std::optional<ContactLaw> law;
    SolverSetting solver = SolverSetting::Newton;
    std::optional<SearchEffort> closestPointSearch;
    DecouplingModel decoupling = DecouplingModel::Estimator;
    std::optional<DeformationModel> deformation;
    // Terms, see ModelTerm; the first four are a matter of the law where that is given.
    std::optional<bool> adhesion = {};
    std::optional<bool> vanDerWaalsTail = {};
    std::optional<bool> sphereCorrection = {};
    std::optional<bool> filmBase = {};
    std::optional<bool> friction = {};
    std::optional<bool> torsion = {};
    std::optional<bool> mountTilt = {};
    std::optional<bool> curvature = {};
    std::optional<bool> bodyAttraction = {};
    std::optional<bool> retractWork = {};
    std::optional<bool> relaxation = {};
    std::optional<bool> drag = {};

    bool operator==(const ModelChoices&) const = default;
};

/// Returns the stated options, and defaults for all that is open; ignores terms of the law.
[[nodiscard]] ForceModelOptions optionsOf(const ModelChoices& choices) noexcept;

/// Returns what is stated of a term itself; none: nothing, or the contact law states it.
[[nodiscard]] std::optional<bool> choiceOf(ModelTerm term, const ModelChoices& choices) noexcept;

/// Returns whether the choices settle if the term is in, by themselves or by the law.
[[nodiscard]] bool isSettled(ModelTerm term, const ModelChoices& choices) noexcept;

/// The choices with the term in or out; none: open. What contradicts that is open, too: other
/// terms, a contact law. The terms of the surface share one choice, the deformation.
[[nodiscard]] ModelChoices withChoice(ModelChoices choices, ModelTerm term,
                                      std::optional<bool> on) noexcept;

/// This force and no other; decoupling and deformation stay as they are.
[[nodiscard]] ModelChoices withForce(ModelChoices choices,
                                     const ForceModelOptions& options) noexcept;

/// All that can be open is; how signals become a force stays.
[[nodiscard]] ModelChoices allAutomatic(const ModelChoices& choices) noexcept;

}  // namespace asperity
