#pragma once

#include "core/contact/Material.h"

#include <cstdint>

namespace asperity {

enum class ContactLaw : std::uint8_t {
    Hertz,  ///< elastic, no adhesion
    Split,  ///< van der Waals tail joined to Maugis-Dugdale (the default)
};

/// Which stable state the tip is in; with adhesion the force is not a function of the gap alone.
enum class ContactBranch : std::uint8_t {
    Far,     ///< before snap-in: van der Waals attraction only
    Bonded,  ///< after snap-in: cohesive zone, with or without contact inside it
};

/// One equilibrium of tip and sample along the surface normal.
struct ContactState {
    double force = 0.0;           ///< on the tip, along the outward normal, > 0 repulsive [N]
    double indentation = 0.0;     ///< approach of the undeformed bodies, < 0 is a gap [m]
    double contactRadius = 0.0;   ///< [m]
    double cohesiveRadius = 0.0;  ///< outer radius of the cohesive zone [m]
    double energyLost = 0.0;      ///< dissipated by a jump that led into this state [J]
    ContactBranch branch = ContactBranch::Far;
    bool jumped = false;  ///< the branch changed on the way to this state
    bool solved = true;   ///< false: the solver failed, the state is the previous branch's nearest
};

/// Normal contact law of one material pair in SI units: constant after construction, no allocation,
/// never throws after construction. Source: docs/physics.md 2.3-2.5, 3.1, 3.4, 7.1.
class ContactModel {
public:
    /// @throw Error when a parameter is outside its range (finite, radius and modulus > 0, w >= 0)
    ContactModel(ContactLaw law, const ContactPair& pair);

    /// Stable equilibrium at `approach` = indentation + compliance x force [m], the approach of the
    /// undeflected tip; `compliance` is the lever's along the normal [m/N] (0: displacement control).
    /// `branch` is the branch of the previous state: it is kept while it is stable.
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           ContactBranch branch) const noexcept;

    [[nodiscard]] ContactLaw law() const noexcept { return law_; }
    [[nodiscard]] const ContactPair& pair() const noexcept { return pair_; }

private:
    ContactLaw law_;
    ContactPair pair_;
};

}  // namespace asperity
