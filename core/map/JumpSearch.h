#pragma once

#include "core/contact/laws/ForceCurve.h"
#include "core/map/VerticalPath.h"

#include <optional>
#include <vector>

namespace asperity {

/// Where the tip changes between free and bonded. On one contact point the contact law knows the
/// jump: `before` is a 64th of the base's way between both jumps away from it, or half of the
/// shortest sampled step. On several, or where a lever that bends to the side loses the equilibrium
/// first, they lie 1e-4 of that way apart: the last
/// equilibrium, and the state beyond it. Where the search began from no equilibrium, and found
/// none, `before` is none.
struct FoundJump {
    TipAtHeight before;
    TipAtHeight after;
    double base = 0.0;       ///< height of the base where it jumps [m]
    bool ofOnePoint = true;  ///< and its law has the jump
    /// On one contact point the contact law's own jump at this place, without the error of the
    /// search; none: the force does not jump.
    std::optional<TipJump> exact;

    /// Whether the force jumps.
    [[nodiscard]] bool jumps() const noexcept { return exact || !ofOnePoint; }
    [[nodiscard]] double energyLost() const noexcept;  ///< [J]
    /// Forces along z on both sides of it [N].
    [[nodiscard]] double forceBefore() const noexcept;
    [[nodiscard]] double forceAfter() const noexcept;
};

/// Lowers the base from a free tip until it snaps in. The law says how far that is; where the
/// surface makes it wrong, the change itself is searched.
/// None: the tip does not snap in.
[[nodiscard]] std::optional<FoundJump> findSnapIn(VerticalPath& path, TipAtHeight from);

/// Raises the base from a bonded tip until it is free, as the path goes: up, or without friction.
/// None: it stays bonded.
/// @param maxStep of the base [m]
/// @param passed gets each state on the way, the first and the last bonded one among them
[[nodiscard]] std::optional<FoundJump>
findPullOff(VerticalPath& path, TipAtHeight from, double maxStep, std::vector<TipAtHeight>& passed);

/// How far the base must rise until the tip pulls off, by the law at its place [m].
[[nodiscard]] double heightToPullOff(const VerticalPath& path, const TipAtHeight& from);

}  // namespace asperity
