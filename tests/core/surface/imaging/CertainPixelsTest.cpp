#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/imaging/TipErosion.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/ScanMaps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace asperity {
namespace {

/// A surface and the radius of the tip that records it.
struct RecordedSurface {
    HeightMap surface;
    double tip = 0.0;  ///< [m]
};

/// Rough, or rough with terraces: steps, walls and hollows of every width beside the tip's.
RecordedSurface randomSurface(Random& random) {
    const ScanSize size{.columns = 40 + static_cast<int>(random.uniform(0.0, 40.0)),
                        .rows = 40 + static_cast<int>(random.uniform(0.0, 40.0)),
                        .sizeX = random.uniform(20.0, 100.0) * 1.0_nm,
                        .sizeY = random.uniform(20.0, 100.0) * 1.0_nm};
    const double longest = std::max(size.sizeX, size.sizeY);
    HeightMap surface = selfAffineMap(size, {.rms = random.uniform(0.0, 6.0) * 1.0_nm,
                                             .hurst = random.uniform(0.3, 0.9),
                                             .longestWave = longest,
                                             .rollOffWave = 0.5 * longest,
                                             .shortestWave = random.uniform(2.0, 8.0) * 1.0_nm,
                                             .seed = random.bits()});
    const double step = std::max(0.0, random.uniform(-8.0, 8.0)) * 1.0_nm;
    for (double& height : surface.heights) {
        height = step > 0.0 ? 0.1 * height + step * std::floor(height / step) : height;
    }
    return {std::move(surface), random.uniform(2.0, 15.0) * 1.0_nm};
}

struct CertainCount {
    long pixels = 0;
    double largestError = 0.0;  ///< of a height that is called certain [m]
};

template <class AnyMap>
CertainCount countCertain(const BasicTipReconstruction<AnyMap>& back, double datum,
                          const HeightMap& truth) {
    CertainCount result;
    for (std::size_t i = 0; i < back.certain.size(); ++i) {
        if (back.certain[i] != 0) {
            ++result.pixels;
            const double height = datum + back.surface.heights[i];
            result.largestError =
                std::max(result.largestError, std::abs(height - truth.heights[i]));
        }
    }
    return result;
}

TEST(CertainPixels, AreTheSurfaceOnAHundredRandomOnes) {
    Random random(43);
    long certain = 0;
    double worst = 0.0;
    for (int run = 0; run < 100; ++run) {
        const RecordedSurface given = randomSurface(random);
        const CertainCount found = countCertain(
            reconstructed(dilated(given.surface, given.tip), given.tip), 0.0, given.surface);
        EXPECT_LT(found.largestError, 1e-12 * given.tip) << "surface " << run;
        certain += found.pixels;
        worst = std::max(worst, found.largestError);
    }
    EXPECT_GT(certain, 10000);
    std::printf("%ld certain pixels of 100 surfaces, at most %.2g m off\n", certain, worst);
}

/// The image is known to half a step of single precision: two heights within that are one.
TEST(CertainPixels, AreTheSurfaceInSinglePrecision) {
    Random random(44);
    long certain = 0;
    for (int run = 0; run < 100; ++run) {
        const RecordedSurface given = randomSurface(random);
        const HeightMap image = dilated(given.surface, given.tip);
        const auto [lowest, highest] = std::ranges::minmax(image.heights);
        const ScanMap stored = test::singlePrecision(image);
        const CertainCount found =
            countCertain(reconstructed(stored, given.tip), stored.datum, given.surface);
        EXPECT_LE(found.largestError,
                  1.01 * std::numeric_limits<float>::epsilon() * (highest - lowest))
            << "surface " << run;
        certain += found.pixels;
    }
    EXPECT_GT(certain, 10000);
}

}  // namespace
}  // namespace asperity
