#pragma once

#include <cstdint>

namespace asperity {

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
    bool solved = true;   ///< false: the input was outside its range; force and lengths are zero
};

}  // namespace asperity
