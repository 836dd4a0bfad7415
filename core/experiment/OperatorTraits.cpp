#include "core/experiment/OperatorTraits.h"

#include <cmath>

namespace asperity {

OperatorTraits drawOperator(Random& random) {
    constexpr double kSpread = 0.2;
    OperatorTraits person;
    for (double* trait : {&person.sightTime, &person.touchTime, &person.moveTime,
                          &person.timePerBit, &person.aimError, &person.acuity, &person.leastForce,
                          &person.tremor, &person.tolerance, &person.patience, &person.dwell,
                          &person.pressTime, &person.arm.stiffness, &person.arm.damping}) {
        *trait *= std::exp(kSpread * random.normal());
    }
    return person;
}

OperatorTraits operatorOf(std::uint64_t seed, int participant) {
    std::uint64_t state = seed;
    state = splitMix64(state) + static_cast<std::uint64_t>(participant);
    Random random(splitMix64(state));
    return drawOperator(random);
}

}  // namespace asperity
