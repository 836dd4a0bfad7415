#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// Surfaces made from a formula; the random ones are the same on every platform for one seed.
/// Formulas: docs/synthetic_surfaces.md.

/// Pixels and size of a made-up scan.
struct ScanSize {
    int columns = 0;
    int rows = 0;
    double sizeX = 0.0;  ///< [m]
    double sizeY = 0.0;  ///< [m]
};

/// A map of this size with all heights 0.
/// @throw Error when there is no pixel or a size is not positive
[[nodiscard]] HeightMap flatMap(const ScanSize& size);

/// z = amplitude sin(2 pi x / periodX + phaseX) sin(2 pi y / periodY + phaseY).
struct EggBox {
    double amplitude = 0.0;  ///< [m]
    double periodX = 1.0;    ///< [m]
    double periodY = 1.0;    ///< [m]
    double phaseX = 0.0;     ///< [rad]
    double phaseY = 0.0;     ///< [rad]

    /// Height and its exact derivatives.
    [[nodiscard]] HeightSample at(double x, double y) const;
    [[nodiscard]] double height(double x, double y) const { return at(x, y).height; }
};

/// Ridges with a flat top and straight flanks.
struct TrapezoidGrating {
    double pitch = 1.0;       ///< [m]
    double depth = 0.0;       ///< [m]
    double topWidth = 0.0;    ///< [m]
    double flankWidth = 0.0;  ///< of one flank seen from above; 0: vertical [m]
    double angle = 0.0;       ///< from x to the direction across the ridges [rad]

    [[nodiscard]] double height(double x, double y) const;
};

/// Terraces of a cut crystal after the plane was removed: steps up, terraces that slope down.
class AtomicSteps {
public:
    struct Recipe {
        double stepHeight = 0.0;    ///< [m]
        double terraceWidth = 1.0;  ///< [m]
        double edgeWidth = 0.0;     ///< over which a step is spread [m]
        double jitter = 0.0;        ///< standard deviation of each step's position [m]
        double angle = 0.0;         ///< from x to the direction across the steps [rad]
        std::uint64_t seed = 1;
    };

    /// @throw Error when a width is not positive or the scan holds more than a million terraces
    AtomicSteps(const Recipe& recipe, const ScanSize& size);

    [[nodiscard]] double height(double x, double y) const;

private:
    Recipe recipe_;
    std::vector<double> steps_;  ///< positions across the steps [m]
};

/// Spheres on a plane as a spherical tip from above sees them.
class Nanoparticles {
public:
    struct Recipe {
        int count = 0;
        double medianRadius = 0.0;   ///< of a log-normal distribution [m]
        double spread = 0.0;         ///< standard deviation of the logarithm of the radius
        double smallest = 0.0;       ///< radii outside smallest..largest are drawn again [m]
        double largest = 0.0;        ///< [m]
        double scanTipRadius = 0.0;  ///< of the tip that scanned; 0: the spheres' own outline [m]
        double clearance = 0.0;      ///< between outlines, and from them to the edges [m]
        std::uint64_t seed = 1;
    };
    struct Particle {
        double x = 0.0;       ///< [m]
        double y = 0.0;       ///< [m]
        double radius = 0.0;  ///< [m]
    };

    /// @throw Error when a size is out of range or there is no room for all particles
    Nanoparticles(const Recipe& recipe, const ScanSize& size);

    [[nodiscard]] double height(double x, double y) const;
    [[nodiscard]] const std::vector<Particle>& particles() const { return particles_; }

private:
    [[nodiscard]] double outlineRadius(double particleRadius) const;
    [[nodiscard]] bool hasRoom(const Particle& particle) const;

    Recipe recipe_;
    std::vector<Particle> particles_;
};

/// Random roughness with a self-affine spectrum; periodic in both directions.
struct SelfAffine {
    double rms = 0.0;           ///< of the heights [m]
    double hurst = 0.8;         ///< Hurst exponent, 0..1
    double longestWave = 1.0;   ///< no waves are longer [m]
    double rollOffWave = 1.0;   ///< the spectrum is flat for waves longer than this [m]
    double shortestWave = 1.0;  ///< no waves are shorter [m]
    std::uint64_t seed = 1;
};

/// The rms height is exact on the grid; the mean is 0.
/// @throw Error when the scan holds no wave between the shortest and the longest
[[nodiscard]] HeightMap selfAffineMap(const ScanSize& size, const SelfAffine& recipe);

/// Banded spherulites of a semicrystalline polymer, grown until they met.
class Spherulites {
public:
    struct Recipe {
        int nuclei = 0;
        double growthHeadStart = 0.0;  ///< the oldest is ahead by this radius [m]
        double domeHeight = 0.0;       ///< [m]
        double domeRadius = 1.0;       ///< [m]
        double bandHeight = 0.0;       ///< amplitude of the rings [m]
        double bandPeriod = 1.0;       ///< [m]
        double bandWaviness = 0.0;     ///< [rad]
        int bandLobes = 0;             ///< ripples around a ring
        double fibrilHeight = 0.0;     ///< amplitude of the radial fibrils [m]
        double fibrilLength = 1.0;     ///< [m]
        int fibrils = 1;               ///< around a full turn
        double grooveDepth = 0.0;      ///< where two spherulites meet [m]
        double grooveWidth = 1.0;      ///< [m]
        std::uint64_t seed = 1;
    };

    /// @throw Error when there is no nucleus or a length is not positive
    Spherulites(const Recipe& recipe, const ScanSize& size);

    [[nodiscard]] double height(double x, double y) const;

private:
    struct Nucleus {
        double x = 0.0;          ///< [m]
        double y = 0.0;          ///< [m]
        double headStart = 0.0;  ///< [m]
    };
    struct Arrival {
        const Nucleus* nucleus = nullptr;
        double radius = 0.0;  ///< distance to the nucleus [m]
        double time = 0.0;    ///< radius less head start [m]
    };

    [[nodiscard]] static Arrival arrivalFrom(const Nucleus& nucleus, double x, double y);
    [[nodiscard]] double heightWithin(const Arrival& arrival, double x, double y) const;
    [[nodiscard]] double fibrilNoise(const Nucleus& nucleus, double radius, double turn) const;

    Recipe recipe_;
    std::vector<Nucleus> nuclei_;
};

/// Samples any of the shapes above at the pixel centers.
template <class Shape>
[[nodiscard]] HeightMap sampledMap(const ScanSize& size, const Shape& shape) {
    HeightMap map = flatMap(size);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] =
                shape.height((column + 0.5) * map.pitchX, (map.rows - row - 0.5) * map.pitchY);
        }
    }
    return map;
}

}  // namespace asperity
