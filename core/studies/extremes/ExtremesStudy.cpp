#include "core/studies/extremes/ExtremesStudy.h"

#include "core/ShareOut.h"
#include "core/studies/extremes/ContactExtremes.h"
#include "core/studies/extremes/TickExtremes.h"

#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

/// A share of the work that one thread does.
using Part = std::function<ExtremesFindings(const CancelCheck&)>;

void addContacts(std::vector<Part>& parts, const ContactGrid& grid) {
    parts.emplace_back([](const CancelCheck& /*check*/) { return refusedContacts(); });
    for (const FlatSample& sample : samplesOf(grid)) {
        parts.emplace_back([&grid, sample](const CancelCheck& check) {
            return contactExtremes(grid, sample, check);
        });
    }
}

void addTicks(std::vector<Part>& parts, const TickGrid& grid) {
    for (const double radius : grid.tipRadii) {
        for (const double roughness : grid.roughnesses) {
            parts.emplace_back(
                [&grid, sample = RoughSample{radius, roughness}](const CancelCheck& check) {
                    return tickExtremes(grid, sample, check);
                });
        }
    }
}

void addHolds(std::vector<Part>& parts, const CouplingGrid& grid) {
    for (const HoldBench& bench : benchesOf(grid)) {
        parts.emplace_back([&grid, bench](const CancelCheck& check) {
            return couplingExtremes(grid, bench, check);
        });
    }
}

/// The parts of every study, those that take longest first.
std::vector<Part> partsOf(const ExtremesGrid& grid) {
    std::vector<Part> parts;
    addHolds(parts, grid.coupling);
    addContacts(parts, grid.contact);
    addTicks(parts, grid.tick);
    return parts;
}

}  // namespace

void ExtremesFindings::addDefect(const std::string& sentence) {
    constexpr std::size_t kExamples = 2;
    ++defects;
    if (examples.size() < kExamples) {
        examples.push_back(sentence);
    }
}

void ExtremesFindings::add(ExtremesFindings&& other) {
    std::move(other.regions.begin(), other.regions.end(), std::back_inserter(regions));
    std::move(other.holds.begin(), other.holds.end(), std::back_inserter(holds));
    states += other.states;
    defects += other.defects;
    std::move(other.examples.begin(), other.examples.end(), std::back_inserter(examples));
}

long ExtremesFindings::answers() const noexcept {
    return std::accumulate(
        regions.begin(), regions.end(), defects,
        [](long sum, const ExtremesRegion& region) { return sum + region.states(); });
}

ExtremesFindings studyExtremes(const ExtremesGrid& grid, Progress* progress) {
    const std::vector<Part> parts = partsOf(grid);
    std::vector<ExtremesFindings> found(parts.size());
    shareOut(static_cast<int>(parts.size()), progress, [&](int index, const CancelCheck& check) {
        const auto i = static_cast<std::size_t>(index);
        found[i] = parts[i](check);
    });
    ExtremesFindings all;
    for (ExtremesFindings& part : found) {
        all.add(std::move(part));
    }
    all.regions = merged(std::move(all.regions));
    return all;
}

}  // namespace asperity
