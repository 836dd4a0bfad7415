#pragma once

#include <cstdint>
#include <vector>

namespace asperity {

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

/// What acts on each pixel. The pressure is contact - sigma0 * cohesion.
struct SurfaceTraction {
    std::vector<double> contact;   ///< pressure of bodies that touch, >= 0 [Pa]
    std::vector<double> cohesion;  ///< the part of the pixel that the cohesive stress acts on, 0..1
};

enum class HalfSpaceStatus : std::uint8_t {
    Converged,
    NotConverged,  ///< the iterations allowed did not reach the tolerance
    Canceled,
};

/// What a solution does not hold for.
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
    double cohesiveRadius = 0.0;       ///< of contact and cohesive zone together, likewise [m]
    double residual = 0.0;             ///< rms gap left in the contact / largest displacement
    int iterations = 0;
    int convolutions = 0;  ///< of any size
    HalfSpaceStatus status = HalfSpaceStatus::NotConverged;
    HalfSpaceDoubts doubts;

    [[nodiscard]] bool valid() const noexcept {
        return status == HalfSpaceStatus::Converged && !doubts.any();
    }
};

}  // namespace asperity
