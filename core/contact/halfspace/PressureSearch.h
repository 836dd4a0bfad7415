#pragma once

#include "core/contact/halfspace/FieldConvolution.h"
#include "core/contact/halfspace/HalfSpaceSolver.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity {

/// The pressure on the pixels of one window: conjugate gradients on the pixels in contact, whose
/// set follows the pressure. Lengths in meters, stresses in pascals; row-major.
/// Source: Polonsky, Keer, Wear 231 (1999) 206.
class PressureSearch {
public:
    /// Material of the window's half-space.
    struct Medium {
        double compliance = 0.0;      ///< pixel pitch / E* [m/Pa]
        double cohesiveStress = 0.0;  ///< [Pa]
        double cohesiveRange = 0.0;   ///< [m]
    };
    /// Fields of one value a pixel.
    struct Fields {
        std::vector<double> rigidGap;  ///< of the undeformed bodies [m]
        SurfaceTraction traction;      ///< at first what to start from
    };

    PressureSearch(const Medium& medium, FieldConvolution& influence,
                   FieldConvolution& preconditioner, Fields fields);

    /// One step towards the pressure that leaves no gap in the contact.
    void advance();

    /// Gap left in the contact, rms, or overlap outside, over the largest displacement; or the
    /// cohesive stress that the last step changed, over the largest pressure, if that is more.
    [[nodiscard]] double residual() const;
    [[nodiscard]] const Fields& fields() const noexcept { return fields_; }
    [[nodiscard]] int convolutions() const noexcept { return convolutions_; }

private:
    void updateGap();
    bool updateCohesion();
    void chooseDirection();
    bool moveAlongDirection();
    [[nodiscard]] double pressureAt(std::size_t pixel) const noexcept;

    Medium medium_;
    FieldConvolution* influence_;
    FieldConvolution* preconditioner_;
    Fields fields_;
    std::vector<double> gap_;            ///< of the deformed bodies [m]
    std::vector<std::uint8_t> touches_;  ///< in contact, or overlapping
    std::vector<double> residual_;       ///< gap of the pixels that touch [m]
    std::vector<double> descent_;        ///< the residual, preconditioned
    std::vector<double> direction_;      ///< that the pressure moves along
    std::vector<double> response_;       ///< displacement by `direction_` [m]
    double product_ = 0.0;               ///< residual . descent of the step before; 0: start again
    double cohesionChange_ = 0.0;        ///< share of pixels' cohesion that the last step changed
    int convolutions_ = 0;
};

/// The part of each pixel whose gap is below `range` [m], 0 .. 1, from the gap at its middle and
/// its slope to the neighbors: on a grid a cohesive zone's edge moves smoothly, not in steps of a
/// pixel. The work of separation of a pixel stays stress x range.
/// @param gaps of size x size pixels, row-major [m]  @param shares as many
void cohesiveShares(std::span<const double> gaps, int size, double range,
                    std::span<double> shares) noexcept;

}  // namespace asperity
