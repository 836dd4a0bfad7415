#include "core/studies/extremes/ExtremesRegion.h"

#include <cmath>

namespace asperity {

Verdict verdictOnError(double error) noexcept {
    if (error <= kExactWithin) {
        return Verdict::Exact;
    }
    return error <= kValidWithin ? Verdict::Valid : Verdict::Off;
}

double relativeError(double value, double reference, double unit) noexcept {
    const double size = std::max({std::abs(value), std::abs(reference), unit});
    return size > 0.0 ? std::abs(value - reference) / size : 0.0;
}

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
                         return one.key() < other.key();
                     });
    std::vector<ExtremesRegion> sums;
    for (ExtremesRegion& region : regions) {
        if (sums.empty() || sums.back().key() != region.key()) {
            sums.push_back(std::move(region));
        } else {
            sums.back().add(region);
        }
    }
    return sums;
}

std::vector<ExtremesRegion> summedBySample(const std::vector<ExtremesRegion>& regions) {
    std::vector<ExtremesRegion> sums;
    for (const ExtremesRegion& region : regions) {
        const RegionKey& key = region.key();
        ExtremesRegion& sum = sums.emplace_back(
            RegionKey{.model = key.model, .setting = key.setting, .sample = key.sample});
        sum.add(region);
    }
    return merged(std::move(sums));
}

}  // namespace asperity
