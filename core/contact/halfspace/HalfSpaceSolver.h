#pragma once

#include "core/contact/halfspace/FieldConvolution.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stop_token>
#include <vector>

namespace asperity {

/// A square of pixels of a square grid; it may reach beyond the grid.
struct PixelWindow {
    int row = 0;     ///< first
    int column = 0;  ///< first
    int size = 0;    ///< pixels per side
};

/// The rectangle around some pixels, inclusive; empty at first.
struct PixelBounds {
    int lowRow = std::numeric_limits<int>::max();
    int lowColumn = std::numeric_limits<int>::max();
    int highRow = -1;
    int highColumn = -1;

    [[nodiscard]] bool empty() const noexcept { return highRow < 0; }
    void include(int row, int column) noexcept;
    void include(const PixelBounds& others) noexcept;
    /// Returns whether all lie inside of the window with `margin` pixels to spare.
    [[nodiscard]] bool within(const PixelWindow& window, int margin) const noexcept;
};

/// The window of a quickly transformed size around bounds that are not empty, with some room to
/// grow, inside of a grid of samples x samples as far as it fits.
[[nodiscard]] PixelWindow windowAround(const PixelBounds& bounds, int samples) noexcept;

/// Calls visit(pixel of the grid, pixel of the window), row-major, for each pixel of both.
template <class Visit>
void forEachInWindow(int samples, const PixelWindow& window, const Visit& visit) {
    const auto pixel = [](int row, int column, int width) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    };
    for (int row = 0; row < window.size; ++row) {
        const int gridRow = window.row + row;
        for (int column = 0; column < window.size; ++column) {
            const int gridColumn = window.column + column;
            if (gridRow >= 0 && gridRow < samples && gridColumn >= 0 && gridColumn < samples) {
                visit(pixel(gridRow, gridColumn, samples), pixel(row, column, window.size));
            }
        }
    }
}

/// A rigid tip above an elastic half-space whose surface need not be smooth, on a square grid of
/// square pixels, row-major.
struct HalfSpaceContact {
    int samples = 0;              ///< pixels per side
    double pitch = 0.0;           ///< of the pixels [m]
    std::vector<double> gap;      ///< of the undeformed bodies at no approach [m]
    double approach = 0.0;        ///< of the bodies from there, > 0 together [m]
    double reducedModulus = 0.0;  ///< E* [Pa]
    double cohesiveStress = 0.0;  ///< sigma0, which acts across gaps < cohesiveRange [Pa]; 0: none
    double cohesiveRange = 0.0;   ///< h0 [m]
    double tipRadius = 0.0;       ///< what contact radii are judged by; of tip and sample together
                                  ///< where that is less than the tip's [m]
};

/// Traction on each pixel. The pressure is contact - sigma0 * cohesion.
struct SurfaceTraction {
    std::vector<double> contact;   ///< pressure of bodies that touch, >= 0 [Pa]
    std::vector<double> cohesion;  ///< the part of the pixel that the cohesive stress acts on, 0..1
};

enum class HalfSpaceStatus : std::uint8_t {
    Converged,
    NotConverged,  ///< the iterations allowed did not reach the tolerance
    Canceled,
};

/// Reasons to doubt a solution.
struct HalfSpaceDoubts {
    bool largeContact = false;   ///< contact radius over tip radius > 0.3: the law of the exact
                                 ///< sphere is the reference there
    bool reachesBorder = false;  ///< contact or cohesion at the border of the grid
    bool tooCoarse = false;      ///< contact or cohesive zone a few pixels wide

    [[nodiscard]] bool any() const noexcept { return largeContact || reachesBorder || tooCoarse; }
};

struct HalfSpaceSolution {
    SurfaceTraction traction;
    std::vector<double> displacement;  ///< into the sample, of both bodies together [m]
    double force = 0.0;                ///< on the tip, > 0 repulsive [N]
    double contactRadius = 0.0;        ///< of the circle of the contact's area [m]
    double cohesiveRadius = 0.0;       ///< of contact and cohesive zone together [m]
    double residual = 0.0;             ///< rms gap left in the contact / largest displacement
    int iterations = 0;
    int convolutions = 0;  ///< of any size
    HalfSpaceStatus status = HalfSpaceStatus::NotConverged;
    HalfSpaceDoubts doubts;

    [[nodiscard]] bool valid() const noexcept {
        return status == HalfSpaceStatus::Converged && !doubts.any();
    }
};

/// Limits at which the iterations stop.
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
