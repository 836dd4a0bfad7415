#include "core/studies/Composition.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kFrameRate = 60.0;     // [Hz]
constexpr double kHapticRate = 1000.0;  // that a device needs to feel a stiff contact [Hz]

double share(double error, double scale) { return scale > 0.0 ? error / scale : 0.0; }

std::vector<Composition> compositions(const TradeOff& study) {
    const TradeOffReference& reference = study.reference;
    std::vector<Composition> all;
    for (std::size_t t = 0; t < study.ticks.size(); ++t) {
        for (std::size_t r = 0; r < study.rates.size(); ++r) {
            if (study.rates[r].rate < kHapticRate) {
                continue;
            }
            const double force =
                std::hypot(study.ticks[t].forceErrorRms, study.rates[r].holdErrorRms);
            for (std::size_t f = 0; f < study.frames.size(); ++f) {
                const FrameResult& frame = study.frames[f];
                all.push_back(
                    {.tick = t,
                     .rate = r,
                     .frame = f,
                     .load =
                         study.rates[r].rate * study.ticks[t].median + kFrameRate * frame.median,
                     .error = std::max(share(force, reference.forceScale),
                                       share(frame.surfaceErrorRms, reference.indentation))});
            }
        }
    }
    return all;
}

Resolution resolutionOf(const TradeOff& study) {
    const TradeOffReference& reference = study.reference;
    return {.cost = study.timeResolution,
            .error = std::max(share(reference.forceDoubt, reference.forceScale),
                              share(reference.surfaceDoubt, reference.indentation))};
}

}  // namespace

std::vector<Composition> bestCompositions(const TradeOff& study) {
    const std::vector<Composition> all = compositions(study);
    const std::vector<bool> front = paretoFront(costsAndErrors(all), resolutionOf(study));
    std::vector<Composition> best;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (front[i]) {
            best.push_back(all[i]);
        }
    }
    std::ranges::sort(best, {}, &Composition::load);
    return best;
}

std::optional<Composition> cheapestComposition(const TradeOff& study, double tolerance) {
    const std::vector<Composition> all = compositions(study);
    const std::size_t best = cheapestWithin(costsAndErrors(all), tolerance, resolutionOf(study));
    return best < all.size() ? std::optional(all[best]) : std::nullopt;
}

}  // namespace asperity
