#pragma once

#include "core/contact/halfspace/HalfSpaceSolver.h"
#include "core/contact/laws/ContactModel.h"

#include <cmath>
#include <cstddef>
#include <functional>

namespace asperity::test {

/// Gap of undeformed bodies at (x, y) from the middle of the grid [m, m -> m].
using GapShape = std::function<double(double, double)>;

struct PixelGrid {
    int samples = 128;
    double halfWidth = 0.0;  ///< [m]

    [[nodiscard]] double pitch() const { return 2.0 * halfWidth / samples; }
    /// Of the middle of a pixel [m].
    [[nodiscard]] double position(int index) const {
        return (index - 0.5 * (samples - 1)) * pitch();
    }
};

/// Bodies of any shape without cohesion.
inline HalfSpaceContact elasticContact(const PixelGrid& grid, const ContactPair& pair,
                                       const GapShape& shape) {
    HalfSpaceContact contact{.samples = grid.samples,
                             .pitch = grid.pitch(),
                             .gap = {},
                             .reducedModulus = pair.reducedModulus,
                             .tipRadius = pair.tipRadius};
    for (int row = 0; row < grid.samples; ++row) {
        for (int column = 0; column < grid.samples; ++column) {
            contact.gap.push_back(shape(grid.position(column), grid.position(row)));
        }
    }
    return contact;
}

/// Paraboloid over a plane, of the law's radius and cohesion.
inline HalfSpaceContact paraboloidContact(const PixelGrid& grid, const ContactModel& model) {
    const ContactPair& pair = model.pair();
    HalfSpaceContact contact = elasticContact(
        grid, pair, [&](double x, double y) { return (x * x + y * y) / (2.0 * pair.tipRadius); });
    contact.cohesiveStress = model.cohesiveStress();
    if (contact.cohesiveStress > 0.0) {
        contact.cohesiveRange = pair.workOfAdhesion / contact.cohesiveStress;
    }
    return contact;
}

/// The displacement at `x` >= 0 on the axis of a grid with an odd number of samples [m].
inline double displacementAt(const HalfSpaceSolution& solution, const PixelGrid& grid, double x) {
    const int middle = grid.samples / 2;
    const double position = x / grid.pitch();
    const int before = static_cast<int>(position);
    const auto at = [&](int steps) {
        const int pixel = middle * grid.samples + middle + steps;
        return solution.displacement[static_cast<std::size_t>(pixel)];
    };
    return std::lerp(at(before), at(before + 1), position - before);
}

}  // namespace asperity::test
