#include "core/studies/extremes/ExtremesRegion.h"

#include <algorithm>
#include <utility>

namespace asperity {

void VerdictTally::add(const VerdictTally& other) {
    states += other.states;
    force.add(other.force);
    contactRadius.add(other.contactRadius);
    jump.add(other.jump);
}

void ExtremesRegion::refuse(const std::string& reason, long states) {
    tallies_[static_cast<std::size_t>(Verdict::Refused)].states += states;
    refusals_[reason] += states;
}

void ExtremesRegion::add(const ExtremesRegion& other) {
    for (std::size_t i = 0; i < tallies_.size(); ++i) {
        tallies_[i].add(other.tallies_[i]);
    }
    for (std::size_t i = 0; i < flags_.size(); ++i) {
        flags_[i] += other.flags_[i];
    }
    for (const auto& [reason, states] : other.refusals_) {
        refusals_[reason] += states;
    }
    solver_.add(other.solver_);
}

void ExtremesRegion::countFlags(ValidityFlags flags) {
    for (std::size_t i = 0; flags.bits() != 0 && i < flags_.size(); ++i) {
        flags_[i] += flags.has(kValidityTraits.at(i).flag) ? 1 : 0;
    }
}

long ExtremesRegion::states() const noexcept {
    long sum = 0;
    for (const VerdictTally& tally : tallies_) {
        sum += tally.states;
    }
    return sum;
}

VerdictTally ExtremesRegion::unflagged() const {
    VerdictTally all;
    for (const Verdict verdict : {Verdict::Exact, Verdict::Valid, Verdict::Off}) {
        all.add(tally(verdict));
    }
    return all;
}

std::string ExtremesRegion::mainReason() const {
    long most = tally(Verdict::Unproven).states;
    std::string reason = most > 0 ? "reference not proven" : "";
    for (std::size_t i = 0; i < flags_.size(); ++i) {
        if (flags_[i] > most) {
            most = flags_[i];
            reason = kValidityTraits.at(i).key;
        }
    }
    for (const auto& [sentence, states] : refusals_) {
        if (states > most) {
            most = states;
            reason = sentence;
        }
    }
    return reason;
}

std::vector<ExtremesRegion> merged(std::vector<ExtremesRegion> regions) {
    std::stable_sort(regions.begin(), regions.end(),
                     [](const ExtremesRegion& one, const ExtremesRegion& other) {
                         return one.place() < other.place();
                     });
    std::vector<ExtremesRegion> sums;
    for (ExtremesRegion& region : regions) {
        if (sums.empty() || sums.back().place() != region.place()) {
            sums.push_back(std::move(region));
        } else {
            sums.back().add(region);
        }
    }
    return sums;
}

std::vector<ExtremesRegion> summedOverPlaces(const std::vector<ExtremesRegion>& regions) {
    std::vector<ExtremesRegion> sums;
    for (const ExtremesRegion& region : regions) {
        const RegionPlace& place = region.place();
        ExtremesRegion& sum = sums.emplace_back(
            RegionPlace{.model = place.model, .setting = place.setting, .sample = place.sample});
        sum.add(region);
    }
    return merged(std::move(sums));
}

}  // namespace asperity
