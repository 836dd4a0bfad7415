#include "core/Error.h"
#include "core/Random.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

/// Rises from 0 to 1 over 0..1 with level ends.
double smoothStep(double t) {
    const double s = std::clamp(t, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

/// A fixed random value in -1..1 for each lattice point.
double latticeValue(std::uint64_t seed, int i, int j) {
    std::uint64_t state = seed ^ (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32U |
                                  static_cast<std::uint32_t>(j));
    return static_cast<double>(splitMix64(state) >> 11U) * 0x1p-52 - 1.0;
}

}  // namespace

Spherulites::Spherulites(const Recipe& recipe, const ScanSize& size) : recipe_(recipe) {
    const bool lengthsArePositive = recipe.domeRadius > 0.0 && recipe.bandPeriod > 0.0 &&
                                    recipe.fibrilLength > 0.0 && recipe.grooveWidth > 0.0;
    if (recipe.nuclei < 1 || recipe.fibrils < 1 || !lengthsArePositive) {
        throw Error("spherulites need a nucleus, a fibril and positive lengths");
    }
    Random random(recipe.seed);
    for (int i = 0; i < recipe.nuclei; ++i) {
        Nucleus nucleus;
        nucleus.x = random.uniform(0.0, size.sizeX);
        nucleus.y = random.uniform(0.0, size.sizeY);
        nucleus.headStart = random.uniform(0.0, recipe.growthHeadStart);
        nuclei_.push_back(nucleus);
    }
}

double Spherulites::height(double x, double y) const {
    Arrival first = arrivalFrom(nuclei_.front(), x, y);
    Arrival second = first;  // a lone spherulite meets no other
    second.time = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < nuclei_.size(); ++i) {
        const Arrival arrival = arrivalFrom(nuclei_[i], x, y);
        if (arrival.time < first.time) {
            second = first;
            first = arrival;
        } else if (arrival.time < second.time) {
            second = arrival;
        }
    }
    const double own = heightWithin(first, x, y);
    // Half the lead in arrival is about the distance to the line where the two met.
    const double fromBoundary = 0.5 * (second.time - first.time);
    const double share = 0.5 + 0.5 * smoothStep(fromBoundary / recipe_.grooveWidth);
    const double depth = fromBoundary / recipe_.grooveWidth;
    return share * own + (1.0 - share) * heightWithin(second, x, y) -
           recipe_.grooveDepth * std::exp(-depth * depth);
}

Spherulites::Arrival Spherulites::arrivalFrom(const Nucleus& nucleus, double x, double y) {
    const double radius = std::hypot(x - nucleus.x, y - nucleus.y);
    return {.nucleus = &nucleus, .radius = radius, .time = radius - nucleus.headStart};
}

double Spherulites::heightWithin(const Arrival& arrival, double x, double y) const {
    const double turn = std::atan2(y - arrival.nucleus->y, x - arrival.nucleus->x);
    const double toEdge = std::max(1.0 - arrival.radius / recipe_.domeRadius, 0.0);
    const double bandPhase = 2.0 * std::numbers::pi * arrival.radius / recipe_.bandPeriod +
                             recipe_.bandWaviness * std::cos(recipe_.bandLobes * turn);
    // Near the nucleus the angle changes too fast for any pixel to follow.
    const double unfolded = smoothStep(arrival.radius / recipe_.bandPeriod);
    return recipe_.domeHeight * toEdge * toEdge +
           unfolded * (recipe_.bandHeight * std::cos(bandPhase) +
                       recipe_.fibrilHeight * fibrilNoise(*arrival.nucleus, arrival.radius, turn));
}

/// Smooth noise on a lattice of radius and angle: long along the radius, narrow across it.
double Spherulites::fibrilNoise(const Nucleus& nucleus, double radius, double turn) const {
    const double along = radius / recipe_.fibrilLength;
    const double around = (turn / (2.0 * std::numbers::pi) + 0.5) * recipe_.fibrils;
    const int ring = static_cast<int>(along);
    const int fibril = std::min(static_cast<int>(around), recipe_.fibrils - 1);
    const int next = (fibril + 1) % recipe_.fibrils;
    const std::uint64_t seed =
        recipe_.seed + 0x10000U * static_cast<std::uint64_t>(&nucleus - nuclei_.data() + 1);
    const double s = smoothStep(along - ring);
    const double t = smoothStep(around - fibril);
    return std::lerp(
        std::lerp(latticeValue(seed, ring, fibril), latticeValue(seed, ring + 1, fibril), s),
        std::lerp(latticeValue(seed, ring, next), latticeValue(seed, ring + 1, next), s), t);
}

}  // namespace asperity
