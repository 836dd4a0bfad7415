#include "core/probe/StaleSignals.h"

#include <cmath>

namespace asperity {

LeverSignals stalenessOf(const LeverSignals& expected, double age, double timeStep,
                         SignalHistory& memory) noexcept {
    const double kept = age > 0.0 ? std::exp(-timeStep / age) : 0.0;
    const LeverSignals last = memory.started ? memory.expected : expected;
    memory = {.expected = expected,
              .change = {.bending = kept * memory.change.bending +
                                    std::abs(expected.bending - last.bending),
                         .torsion = kept * memory.change.torsion +
                                    std::abs(expected.torsion - last.torsion)},
              .started = true};
    return age > 0.0 ? memory.change : LeverSignals{};
}

}  // namespace asperity
