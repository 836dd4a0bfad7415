#include "core/surface/fit/LineFit.h"

#include "core/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace asperity {
namespace {

/// Weight of a sample for a control height, as the line fit applies it.
double weight(const LineFit& fit, int control, int sample) {
    const int mirrored = fit.controls() - 1 - control;
    if (control < fit.border()) {
        return sample < fit.span() ? fit.borderWeights(control)[sample] : 0.0;
    }
    if (mirrored < fit.border()) {
        const int fromEnd = fit.samples() - 1 - sample;
        return fromEnd < fit.span() ? fit.borderWeights(mirrored)[fromEnd] : 0.0;
    }
    const int distance = std::abs(sample - (control - 1));
    if (distance == 0) {
        double middle = 1.0;
        for (const float other : fit.kernel()) {
            middle -= 2.0 * static_cast<double>(other);
        }
        return middle;
    }
    return distance <= fit.reach() ? fit.kernel()[static_cast<std::size_t>(distance - 1)] : 0.0;
}

TEST(LineFit, NeglectsLessThanTheRoundingOfAHeight) {
    for (const double sigma : {0.0, 0.04, 0.3, 1.0, 1.5, 4.0}) {
        for (const int samples : {1, 2, 3, 50, 97, 98, 99, 133, 134, 300}) {
            const LineFit fit(samples, sigma);
            const std::vector<double> exact = lineFitWeights(samples, sigma);
            for (int control = 0; control < fit.controls(); ++control) {
                double difference = 0.0;
                for (int sample = 0; sample < samples; ++sample) {
                    difference +=
                        std::abs(weight(fit, control, sample) -
                                 exact[static_cast<std::size_t>(control * samples + sample)]);
                }
                // what is left out, and the rounding of the kernel
                ASSERT_LE(difference, 2.0 * LineFit::kNeglected + 0x1p-24)
                    << "sigma " << sigma << ", " << samples << " samples, control " << control;
            }
        }
    }
}

TEST(LineFit, OfALongLineNeedsFewWeights) {
    EXPECT_LE(LineFit(4096, 0.0).reach(), 15);
    EXPECT_LE(LineFit(4096, 1.5).reach(), 12);
    EXPECT_LE(LineFit(4096, 1.5).border(), 30);
    EXPECT_FALSE(LineFit(4096, 1.5).isAllBorder());
    EXPECT_TRUE(LineFit(20, 1.5).isAllBorder());
}

TEST(LineFit, RefusesWidthsThatAreNoNumbersAndLinesWithoutSamples) {
    for (const double sigma : {-1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e9}) {
        EXPECT_THROW(LineFit(10, sigma), Error);
        EXPECT_THROW(LineFit(100000, sigma), Error);
    }
    EXPECT_THROW(LineFit(0, 1.0), Error);
}

}  // namespace
}  // namespace asperity
