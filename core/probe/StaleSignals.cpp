#include "core/probe/StaleSignals.h"

#include <algorithm>
#include <cmath>

namespace asperity {

LeverSignals stalenessOf(const LeverSignals& expected, double age, double timeStep,
                         SignalHistory& memory) noexcept {
    const double kept = age > 0.0 ? std::exp(-timeStep / age) : 0.0;
    const LeverSignals last = memory.started ? memory.expected : expected;
    const auto fastest = [&](double now, double before, double rate) {
        return std::max(std::abs(now - before) / timeStep, kept * rate);
    };
    memory = {.expected = expected,
              .rate = {.bending = fastest(expected.bending, last.bending, memory.rate.bending),
                       .torsion = fastest(expected.torsion, last.torsion, memory.rate.torsion)},
              .started = true};
    return {.bending = memory.rate.bending * age, .torsion = memory.rate.torsion * age};
}

}  // namespace asperity
