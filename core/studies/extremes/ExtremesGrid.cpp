#include "core/studies/extremes/ExtremesGrid.h"

#include "core/studies/extremes/TickExtremes.h"

#include <algorithm>
#include <limits>

namespace asperity {

namespace {

constexpr double kTickShare = 0.03;  // of all states: each takes as long as some hundred others

constexpr double kHoldShare = 0.0029;  // of all states: each takes as long as some thousand others

long product(std::initializer_list<std::size_t> counts) {
    long result = 1;
    for (const std::size_t count : counts) {
        result *= static_cast<long>(count);
    }
    return result;
}

/// Every number of steps of the coupling's grid is made of 2 and 3: a stride without these factors
/// takes every value of every two quantities with each other.
long strideFor(double part, long whole) {
    return 1 + 6 * std::lround(std::max(0.0, static_cast<double>(whole) / part - 1.0) / 6.0);
}

/// Returns how many times a part goes into a number of states, at least `fewest`.
int timesIn(double states, long part, int fewest) {
    return std::max(fewest, static_cast<int>(std::lround(states / static_cast<double>(part))));
}

}  // namespace

long ContactGrid::ways() const noexcept {
    const std::size_t samples = moduli.size() * (adhesions.size() + films.size());
    return product({samples, tipRadii.size(), leverStiffnesses.size()});
}

long TickGrid::runs() const noexcept {
    return product({tickMaterials().size(), tipRadii.size(), roughnesses.size(),
                    leverStiffnesses.size(), depths.size()});
}

long CouplingGrid::settings() const noexcept {
    return product({holdMaterials().size(), leverStiffnesses.size(), tickRates.size(),
                    delays.size(), positionGains.size(), forceGains.size(), kValues<Grip>.size()});
}

long CouplingGrid::holds() const noexcept { return 2 * ((settings() + stride - 1) / stride); }

long ExtremesGrid::states() const noexcept {
    return (contact.ways() * 2 * contact.stops) + (tick.runs() * tick.ticks) + coupling.holds();
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
                    .films = {{.thickness = 10e-9, .poissonRatio = 0.5},
                              {.thickness = 1e-6, .poissonRatio = 0.3}},
                    .leverStiffnesses = {1e-3, 0.01, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, kRigid}},
        .tick = {.tipRadii = logSpaced(smallest, largest, steps(6)),
                 .roughnesses = {0.0, 0.001, 0.003, 0.01, 0.03, 0.1},
                 .leverStiffnesses = {0.01, 1.0, 100.0},
                 .depths = {0.05, 0.2}},
        .coupling = {.leverStiffnesses = {0.2, 3.0, 40.0},
                     .tickRates = {100.0, 250.0, 500.0, 1e3, 2e3, 5e3, 10e3, 20e3},
                     .delays = {0.0, 1e-3, 2e-3, 5e-3},
                     .positionGains = {1e-7, 1e-6, 1e-5},
                     .forceGains = {1e7, 1e8, 1e9, 1e10}}};
    grid.coupling.stride = strideFor(0.5 * kHoldShare * states, grid.coupling.settings());
    grid.tick.ticks = timesIn(kTickShare * states, grid.tick.runs(), 5);
    const double left =
        states - static_cast<double>((grid.tick.runs() * grid.tick.ticks) + grid.coupling.holds());
    grid.contact.stops = timesIn(0.5 * left, grid.contact.ways(), 4);
    return grid;
}

}  // namespace asperity
