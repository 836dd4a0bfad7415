#pragma once

#include "core/contact/halfspace/FieldConvolution.h"
#include "core/contact/halfspace/HalfSpaceContact.h"
#include "core/contact/halfspace/PixelWindow.h"

#include <map>
#include <stop_token>

namespace asperity {

/// How far a solution is driven.
struct HalfSpaceLimits {
    double tolerance = 1e-3;  ///< of the gaps left in the contact, over the largest displacement
    int iterations = 300;
};

/// Solves for the pressure between a rigid tip and an elastic half-space of any shape, in
/// displacement control: boundary elements on a regular grid (Love's kernel, padded fast
/// convolution), conjugate gradients within the contact, which grows and shrinks on the way, with
/// Dugdale's cohesive stress across small gaps. Where more than one state is stable, the one
/// reached from the start is found. Only the part of the grid around the contact is iterated.
/// Keeps transforms for reuse: one object a thread. Off the tick: allocates.
/// Source: Polonsky, Keer (1999); Vollebregt, Zhao (2014); docs/theory.md 2, 4.
class HalfSpaceSolver {
public:
    explicit HalfSpaceSolver(HalfSpaceLimits limits = {});

    /// @param start what to start from, of a contact with as many samples; empty: separate bodies
    /// @param stop  ends the search between two iterations
    /// @throw Error when the contact's sizes are not positive or do not match
    [[nodiscard]] HalfSpaceSolution solve(const HalfSpaceContact& contact,
                                          const SurfaceTraction& start = {},
                                          const std::stop_token& stop = {});

private:
    /// The transforms of one size of a field.
    struct Operators {
        FieldConvolution influence;
        FieldConvolution preconditioner;
    };
    [[nodiscard]] Operators& operatorsOf(int size);
    void searchIn(const PixelWindow& window, const HalfSpaceContact& contact,
                  HalfSpaceSolution& solution, const std::stop_token& stop);
    void displace(const HalfSpaceContact& contact, HalfSpaceSolution& solution);

    HalfSpaceLimits limits_;
    std::map<int, Operators> operators_;
};

}  // namespace asperity
