#include "core/fidelity/extremes/ExtremesStudy.h"

#include "core/ShareOut.h"
#include "core/fidelity/extremes/ContactExtremes.h"
#include "core/fidelity/extremes/LogSpaced.h"
#include "core/fidelity/extremes/RefusedContacts.h"
#include "core/fidelity/extremes/TickExtremes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

std::vector<RoughPlace> placesOf(const TickGrid& grid) {
    std::vector<RoughPlace> places;
    for (const double radius : grid.tipRadii) {
        for (const double roughness : grid.roughnesses) {
            places.push_back({radius, roughness});
        }
    }
    return places;
}

}  // namespace

ExtremesGrid ExtremesGrid::ofAbout(double states) {
    constexpr double kFull = 2.8e6;  // states with the numbers of steps below
    const double fineness = std::cbrt(states / kFull);
    const auto steps = [fineness](int full) {
        return std::max(2, static_cast<int>(std::lround(fineness * full)));
    };
    constexpr double kRigid = std::numeric_limits<double>::infinity();
    const double smallest = 0.5e-9;  // tip radius [m]
    const double largest = 10e-6;    // tip radius [m]
    return {.contact = {.tipRadii = logSpaced(smallest, largest, steps(10)),
                        .moduli = logSpaced(1e4, 1e12, steps(17)),
                        .adhesions = {0.0, 1e-3, 0.01, 0.05, 0.2, 1.0},
                        .filmThicknesses = {10e-9, 1e-6},
                        .leverStiffnesses = {1e-3, 0.1, 1.0, 10.0, 1e4, kRigid},
                        .places = 2 * steps(6)},
            .tick = {.tipRadii = logSpaced(smallest, largest, steps(6)),
                     .roughnesses = {0.0, 0.001, 0.01, 0.1},
                     .leverStiffnesses = {0.01, 1.0, 100.0},
                     .rates = {100.0, 1000.0, 20000.0},
                     .gainShares = {0.01, 1.0},
                     .ticks = 10 * steps(6)}};
}

void ExtremesFindings::addDefect(const std::string& sentence) {
    constexpr std::size_t kExamples = 2;
    ++defects;
    if (examples.size() < kExamples) {
        examples.push_back(sentence);
    }
}

void ExtremesFindings::add(ExtremesFindings&& other) {
    std::move(other.regions.begin(), other.regions.end(), std::back_inserter(regions));
    defects += other.defects;
    std::move(other.examples.begin(), other.examples.end(), std::back_inserter(examples));
}

long ExtremesFindings::states() const noexcept {
    return std::accumulate(
        regions.begin(), regions.end(), defects,
        [](long sum, const ExtremesRegion& region) { return sum + region.states(); });
}

ExtremesFindings studyExtremes(const ExtremesGrid& grid, Progress* progress) {
    const std::vector<FlatSample> samples = samplesOf(grid.contact);
    const std::vector<RoughPlace> roughs = placesOf(grid.tick);
    std::vector<ExtremesFindings> parts(samples.size() + roughs.size());
    shareOut(static_cast<int>(parts.size()), progress, [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        parts[i] = i < samples.size() ? contactExtremes(grid.contact, samples[i])
                                      : tickExtremes(grid.tick, roughs[i - samples.size()]);
    });
    ExtremesFindings all = refusedContacts();
    for (ExtremesFindings& part : parts) {
        all.add(std::move(part));
    }
    all.regions = merged(std::move(all.regions));
    return all;
}

}  // namespace asperity
