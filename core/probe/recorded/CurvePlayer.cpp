#include "core/probe/recorded/CurvePlayer.h"

#include <algorithm>

namespace asperity {

double CurvePlayer::Fading::at(double distance) const noexcept {
    return force == 0.0 ? 0.0 : force * std::clamp((distance - to) / (from - to), 0.0, 1.0);
}

bool CurvePlayer::touches() const noexcept {
    return branch_ == Branch::Retract
               ? !isFree()
               : !isAbove_ && curve_.approach.distanceAt(down_) <= curve_.touch;
}

bool CurvePlayer::isFree() const noexcept {
    const double distance = curve_.retract.distanceAt(up_);
    return distance > curve_.free && distance + shift_ > curve_.touch;
}

PlayedForce CurvePlayer::moveTo(double distance) noexcept {
    const PlayedBranch& branch = curve_.approach;
    if (distance < branch.distance.back() - branch.slack) {
        down_ = branch.end();
        turn();
        return {.beyond = true};
    }
    return branch_ == Branch::Approach ? approach(distance) : retract(distance);
}

PlayedForce CurvePlayer::approach(double distance) noexcept {
    const PlayedBranch& branch = curve_.approach;
    const std::optional<BranchPlace> found = approached(distance);
    if (!found && touches()) {
        turn();
        return retract(distance);
    }
    if (!found) {
        beginAgain();
        return {};
    }
    isAbove_ = false;
    down_ = *found;
    const double faded = fading_.at(distance);
    return {.force = branch.forceAt(down_) + faded, .extrapolated = faded != 0.0};
}

/// The next place on the approach; none: the base is above its record, or turns in contact.
std::optional<BranchPlace> CurvePlayer::approached(double distance) const noexcept {
    const PlayedBranch& branch = curve_.approach;
    if (isAbove_) {
        return branch.first(distance);
    }
    if (down_ == branch.end()) {
        return std::nullopt;
    }
    const std::optional<BranchPlace> further = distance < branch.distanceAt(down_)
                                                   ? branch.ahead(down_, distance)
                                                   : branch.next(down_, distance);
    return further || touches() ? further : branch.behind(down_, distance);
}

void CurvePlayer::turn() noexcept {
    const double distance = curve_.approach.distanceAt(down_);
    const double force = curve_.approach.forceAt(down_);
    branch_ = Branch::Retract;
    up_ = curve_.retract.withForce(force).value_or(BranchPlace{});
    highest_ = up_;
    shift_ = distance - curve_.retract.distanceAt(up_);
    asRecorded_ = down_ == curve_.approach.end();
    fading_ = {.force = force - curve_.retract.forceAt(up_),
               .from = distance,
               .to = std::ranges::max(curve_.retract.distance) + shift_};
}

PlayedForce CurvePlayer::retract(double distance) noexcept {
    const PlayedBranch& branch = curve_.retract;
    const double recorded = distance - shift_;
    const bool rises = recorded > branch.distanceAt(up_);
    const std::optional<BranchPlace> further =
        rises ? branch.ahead(up_, recorded) : branch.next(up_, recorded);
    if (further) {
        up_ = *further;
        highest_ = std::max(highest_, up_);
        return retracted(distance);
    }
    if (rises) {
        beginAgain();
        return approach(distance);
    }
    return retrace(distance);
}

/// Down again, where the record went up.
PlayedForce CurvePlayer::retrace(double distance) noexcept {
    const PlayedBranch& branch = curve_.retract;
    if (!asRecorded_ && distance <= curve_.approach.distanceAt(down_)) {
        branch_ = Branch::Approach;
        fading_ = {};
        return approach(distance);
    }
    if (isFree()) {
        const double turned = branch.distanceAt(up_) + shift_;
        const double force = retracted(turned).force;
        beginAgain();
        fading_ = {.force = force - approach(turned).force, .from = turned, .to = curve_.touch};
        return approach(distance);
    }
    up_ = branch.behind(up_, distance - shift_).value_or(BranchPlace{});
    return retracted(distance);
}

PlayedForce CurvePlayer::retracted(double distance) const noexcept {
    return {.force = curve_.retract.forceAt(up_) + fading_.at(distance),
            .extrapolated = !asRecorded_ || up_ < highest_};
}

void CurvePlayer::beginAgain() noexcept {
    branch_ = Branch::Approach;
    isAbove_ = true;
    fading_ = {};
}

}  // namespace asperity
