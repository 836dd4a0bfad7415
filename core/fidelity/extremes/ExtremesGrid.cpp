#include "core/fidelity/extremes/ExtremesGrid.h"

#include "core/fidelity/extremes/LogSpaced.h"
#include "core/fidelity/extremes/TickExtremes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kTickShare = 0.03;  // of all states: each takes as long as some hundred others

long product(std::initializer_list<std::size_t> counts) {
    long result = 1;
    for (const std::size_t count : counts) {
        result *= static_cast<long>(count);
    }
    return result;
}

/// How many times a part goes into a number of states, at least `fewest`.
int timesIn(double states, long part, int fewest) {
    return std::max(fewest, static_cast<int>(std::lround(states / static_cast<double>(part))));
}

}  // namespace

long ContactGrid::ways() const noexcept {
    const std::size_t samples = moduli.size() * (adhesions.size() + filmThicknesses.size());
    return product({samples, tipRadii.size(), leverStiffnesses.size()});
}

long TickGrid::runs() const noexcept {
    return product({tickMaterials().size(), tipRadii.size(), roughnesses.size(),
                    leverStiffnesses.size(), depths.size()});
}

long ExtremesGrid::states() const noexcept {
    return (contact.ways() * 2 * contact.places) + (tick.runs() * tick.ticks);
}

ExtremesGrid ExtremesGrid::ofAbout(double states) {
    constexpr double kFull = 1.1e6;  // states with the numbers of steps below
    const double fineness = std::cbrt(states / kFull);
    const auto steps = [fineness](int full) {
        return std::max(2, static_cast<int>(std::lround(fineness * full)));
    };
    constexpr double kRigid = std::numeric_limits<double>::infinity();
    const double smallest = 0.5e-9;  // tip radius [m]
    const double largest = 10e-6;    // tip radius [m]
    ExtremesGrid grid{
        .contact = {.tipRadii = logSpaced(smallest, largest, steps(23)),
                    .moduli = logSpaced(1e4, 1e12, steps(13)),
                    .adhesions = {0.0, 1e-3, 0.01, 0.05, 0.2, 1.0},
                    .filmThicknesses = {10e-9, 1e-6},
                    .leverStiffnesses = {1e-3, 0.01, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, kRigid}},
        .tick = {.tipRadii = logSpaced(smallest, largest, steps(6)),
                 .roughnesses = {0.0, 0.001, 0.003, 0.01, 0.03, 0.1},
                 .leverStiffnesses = {0.01, 1.0, 100.0},
                 .depths = {0.05, 0.2}}};
    grid.tick.ticks = timesIn(kTickShare * states, grid.tick.runs(), 5);
    const double left = states - static_cast<double>(grid.tick.runs() * grid.tick.ticks);
    grid.contact.places = timesIn(0.5 * left, grid.contact.ways(), 4);
    return grid;
}

}  // namespace asperity
