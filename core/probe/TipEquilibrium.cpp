#include "core/probe/TipEquilibrium.h"

#include "core/contact/Within.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipContactPoint.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/sample/SampleSurface.h"

#include <Eigen/LU>

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace asperity {

namespace {

constexpr int kMaxSweeps = 48;
// From here on a contact that has jumped stays so. Where effective radius and normal change with
// the position, a bond may break at the position to which it pulls the tip, and hold at the one to
// which the lever takes the free tip: then no bonded state balances the lever, and the search would
// go to and fro between the two.
constexpr int kJumpsStay = kMaxSweeps / 2;
constexpr double kPositionTolerance = 1.0 / 15e6;  // of the tip's radius: 1 fm of 15 nm
constexpr double kSameSlot = 0.25;  // of the tip's radius: a point moves less from tick to tick
// How far the tip may move, of its radius, until closest points are looked for again: little where
// it hardly moves, since a wide look finds many points that bear nothing.
constexpr double kNarrowLook = 0.002;
constexpr double kWideLook = 0.02;
constexpr double kMainPoint = 1.5;  // another point becomes the main one with so much more force
constexpr double kBears = 1e-3;     // share of the main point's force from which a point counts

/// Returns whether the contact laws can be asked at a position, whatever lies below it.
bool isWithinWorld(const Vector3& position) {
    constexpr double kMaxCoordinate = 500.0;  // [m]
    return isWithin(position.x(), -kMaxCoordinate, kMaxCoordinate) &&
           isWithin(position.y(), -kMaxCoordinate, kMaxCoordinate) &&
           isWithin(position.z(), -kMaxCoordinate, kMaxCoordinate);
}

TipState nowhere() {
    TipState state;
    state.contact.status = ContactStatus::ApproachOutOfRange;
    return state;
}

/// Search for the tip's position between a lever of given compliance and all its closest points,
/// one closest point at a time while the others answer to first order.
class Balance {
public:
    Balance(const SampleSurface& surface, const ProbeSystem& system, const BaseMotion& base,
            const Matrix3& compliance, ClosestPointTracker& tracker)
        : surface_(surface)
        , system_(system)
        , base_(base)
        , compliance_(compliance)
        , tolerance_(kPositionTolerance * system.tipRadius())
        , range_(system.contact.attractionRange())
        , tracker_(tracker)
        , beside_(system) {}

    TipState solve(EquilibriumMemory& memory) {
        margin_ = marginFor(memory);
        // Several points hold the tip where it is when the base moves; else it goes with the base.
        deflection_ = recalls(memory) ? Vector3(memory.tip - base_.position) : memory.deflection;
        findPoints(memory);
        for (int i = 0; i < kMaxSweeps && !state_.converged; ++i) {
            const Vector3 before = deflection_;
            state_.locked = false;
            for (TipContactPoint& closest : points_) {
                settle(closest);
                if (i >= kJumpsStay) {
                    closest.keepJump();
                }
            }
            dropDoubledPoints();
            const bool still = (deflection_ - before).norm() <= tolerance_;
            state_.converged = still && !followSample() && !beside_.follow(points(), tip()) &&
                               !findMorePoints(memory);
        }
        for (TipContactPoint& closest : points_) {
            closest.tellJump();
        }
        putMainPointFirst();
        report();
        state_.mayLackPoint = mayMissPoints(state_.proof) || (memory.mayLackPoint && mayBeHeld());
        remember(memory);
        return state_;
    }

private:
    /// The lever as one closest point meets it: stiffened by the other closest points, and moved by
    /// them.
    struct Lever {
        Matrix3 compliance;
        Vector3 offset;  ///< of the tip when the closest point bears no force [m]
    };

    [[nodiscard]] Vector3 tip() const { return base_.position + deflection_; }
    [[nodiscard]] Vector3 center() const {
        return base_.position + deflection_ + Vector3(0.0, 0.0, system_.tipRadius());
    }
    [[nodiscard]] std::span<TipContactPoint> points() { return {points_.data(), points_.size()}; }

    /// Returns how far the tip may move from where closest points are looked for [m]. A lever bends
    /// by less than its base moves, as long as nothing jumps.
    [[nodiscard]] double marginFor(const EquilibriumMemory& memory) const {
        const double moved = (base_.position - (memory.tip - memory.deflection)).norm();
        const double narrow = kNarrowLook * lookScale();
        return memory.pointCount > 0 && moved <= narrow ? narrow : kWideLook * lookScale();
    }

    /// Returns what is wide for a look [m]: the tip's radius, but for a blunt tip what is beyond
    /// the range of its attraction many times bears nothing.
    [[nodiscard]] double lookScale() const {
        constexpr double kManyRanges = 50.0;  // a wide look doubles the range
        const double radius = system_.tipRadius();
        return range_ > 0.0 ? std::min(radius, kManyRanges * range_) : radius;
    }

    /// Returns how far from the tip's center a closest point without a bond bears a force [m].
    [[nodiscard]] double bearsWithin() const { return system_.tipRadius() + range_; }

    void findPoints(const EquilibriumMemory& memory) {
        boost::container::static_vector<SearchGuess, kMaxContactPoints> known;
        for (std::size_t i = 0; i < memory.pointCount; ++i) {
            known.push_back(memory.points[i].guess);
        }
        addPoints({known.data(), known.size()}, memory);
        followSample();
        beside_.sum(points(), beside_.likelyTip(points_.front(), tip(), memory.tip));
        if (recalls(memory)) {
            recallForces();
        }
    }

    /// Returns whether several points hold the tip, and the base has not been moved to other ones.
    [[nodiscard]] bool recalls(const EquilibriumMemory& memory) const {
        const auto end = memory.points.begin() + static_cast<std::ptrdiff_t>(memory.pointCount);
        const Vector3 moved = base_.position - (memory.tip - memory.deflection);
        return memory.pointCount > 1 && moved.head<2>().norm() <= kSameSlot * system_.tipRadius() &&
               std::any_of(memory.points.begin(), end, [](const ClosestPointMemory& point) {
                   return point.contact.branch == ContactBranch::Bonded;
               });
    }

    /// Recalls what each point bears where the tip was left. The first one to be settled would else
    /// have to bear all that the lever pulls, and would let go where they hold the tip together.
    void recallForces() {
        beside_.pull(points(), tip(), 0.0);
        for (TipContactPoint& closest : points_) {
            closest.hold(system_.tipRadius(), base_.velocity);
            closest.foundAt = deflection_;
        }
    }

    /// Where the tip has moved by so much since the last look that closest points may bear which
    /// did not, there is another look.
    bool findMorePoints(const EquilibriumMemory& memory) {
        if ((center() - lookedFrom_).norm() <= freeToMove_) {
            return false;
        }
        const bool dropped = dropIdlePoints();
        boost::container::static_vector<SearchGuess, kMaxContactPoints> known;
        for (const TipContactPoint& closest : points_) {
            known.push_back(closest.foot.guess());
        }
        const std::size_t before = points_.size();
        addPoints({known.data(), known.size()}, memory);
        followSample();
        const bool changed = dropped || points_.size() > before;
        if (changed) {
            beside_.sum(points(), tip());
        }
        return changed;
    }

    /// Makes room: points beside the main one that nothing bonds and that lie out of range.
    bool dropIdlePoints() {
        const std::size_t before = points_.size();
        for (std::size_t i = points_.size(); i-- > 1;) {
            if (points_[i].contact.branch == ContactBranch::Far &&
                points_[i].foot.distance > bearsWithin()) {
                points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
        return points_.size() < before;
    }

    /// Looks no farther than as the points can be told apart: of too many near a blunt tip those
    /// that bear could be missed.
    ContactPoints lookWith(std::span<const SearchGuess> known) {
        constexpr int kMaxNarrower = 4;
        constexpr double kNarrower = 0.25;
        const auto look = [&] {
            return surface_.contactPoints({lookedFrom_, system_.tipRadius()}, range_ + margin_,
                                          known, tracker_);
        };
        ContactPoints found = look();
        for (int i = 0; i < kMaxNarrower && found.proof == SearchProof::TooManyPoints; ++i) {
            margin_ *= kNarrower;
            found = look();
        }
        return found;
    }

    void addPoints(std::span<const SearchGuess> known, const EquilibriumMemory& memory) {
        lookedFrom_ = center();
        const ContactPoints found = lookWith(known);
        freeToMove_ = margin_;
        state_.proof = found.proof;
        joined_ = found.joined;
        for (const ClosestPoint& foot : found.list.all()) {
            if (!isKnown(foot, points_.size())) {
                addPoint(foot, memory);
            }
        }
        addHeldPoints(memory);
    }

    /// Takes a closest point up that bears a force, or the first one.
    void addPoint(const ClosestPoint& foot, const EquilibriumMemory& memory) {
        const ClosestPointMemory known = takeMemory(foot, memory);
        const bool isBonded = known.contact.branch == ContactBranch::Bonded;
        if (!points_.empty() && !isBonded && foot.distance > bearsWithin()) {
            freeToMove_ = std::min(freeToMove_, foot.distance - bearsWithin());
        } else if (points_.size() == kMaxContactPoints) {
            state_.proof = SearchProof::TooManyPoints;
        } else {
            TimeTerms terms = system_.time;
            if (!points_.empty()) {
                terms.drag = 0.0;  // the liquid flows out of one gap
            }
            points_.push_back({.foot = foot,
                               .memory = known,
                               .timed = {terms, known.time, base_.elapsed},
                               .model = system_.contact,
                               .friction = system_.friction,
                               .radius = {},
                               .contact = {.indentation = known.time.indentation}});
        }
    }

    /// A contact that holds the tip by a neck may lie farther than anything that snaps in.
    void addHeldPoints(const EquilibriumMemory& memory) {
        for (std::size_t i = 0; i < memory.pointCount; ++i) {
            const ClosestPointMemory& held = memory.points[i];
            if (!taken_[i] && held.contact.branch == ContactBranch::Bonded) {
                const ClosestPoint foot = surface_.localContactPoint(lookedFrom_, held.guess);
                if (foot.converged && !isKnown(foot, points_.size())) {
                    addPoint(foot, memory);
                }
            }
        }
    }

    /// Returns whether one of the first `count` closest points lies there.
    [[nodiscard]] bool isKnown(const ClosestPoint& foot, std::size_t count) const {
        const double same = kSamePoint * system_.tipRadius();
        return std::any_of(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(count),
                           [&](const TipContactPoint& closest) {
                               return (closest.foot.point - foot.point).norm() <= same;
                           });
    }

    /// Returns what was known of a closest point: of the nearest one remembered that no other
    /// closest point has taken. The first closest point is always known.
    [[nodiscard]] ClosestPointMemory takeMemory(const ClosestPoint& foot,
                                                const EquilibriumMemory& memory) {
        std::size_t best = points_.empty() ? 0 : memory.pointCount;
        double nearest = kSameSlot * system_.tipRadius();
        for (std::size_t i = 0; i < memory.pointCount; ++i) {
            const SearchGuess& guess = memory.points[i].guess;
            const double away = std::hypot(guess.x - foot.point.x(), guess.y - foot.point.y());
            if (!taken_[i] && away < nearest) {
                nearest = away;
                best = i;
            }
        }
        if (best >= memory.pointCount) {
            return {};
        }
        taken_[best] = true;
        return memory.points[best];
    }

    /// Updates effective radius and material at each closest point; whether one of them changed.
    bool followSample() {
        bool changed = false;
        for (TipContactPoint& closest : points_) {
            changed |= closest.followSample(system_);
        }
        return changed;
    }

    [[nodiscard]] Lever leverOf(const TipContactPoint& closest) const {
        if (points_.size() == 1) {
            return {compliance_, Vector3::Zero()};
        }
        Matrix3 stiffness = Matrix3::Zero();
        Vector3 force = Vector3::Zero();
        for (const TipContactPoint& other : points_) {
            if (&other != &closest) {
                const Vector3& normal = other.foot.normal;
                stiffness += other.stiffness() * normal * normal.transpose();
                force += other.forceAt(deflection_);
            }
        }
        const Matrix3 stiffened =
            (Matrix3::Identity() + compliance_ * stiffness).inverse() * compliance_;
        return {stiffened, stiffened * (force + stiffness * deflection_)};
    }

    /// Balances lever and contact at one closest point.
    void settle(TipContactPoint& closest) {
        closest.foot = surface_.localContactPoint(center(), closest.foot.guess());
        const Vector3& normal = closest.foot.normal;
        closest.slip = slidingOf(normal, base_.velocity).slip();
        const Lever lever = leverOf(closest);
        const double along = normal.dot(lever.compliance * normal);
        const double across = normal.dot(lever.compliance * closest.slip);
        const double withFriction = along + closest.friction.coefficient * across;
        // Friction that drags the tip deeper faster than the lever lifts it locks it.
        const bool locks = along > 0.0 && withFriction <= 0.0;
        state_.locked |= locks;
        // The part mu N of friction is solved with N, as a change of the lever's compliance
        // (1 / k_n of docs/theory.md 7.2); the rest, of the area, is that of the last sweep.
        const bool slides = closest.memory.friction > 0.0 && !locks;
        if (&closest == &points_.front()) {
            beside_.pull(points(), tip(), std::max(along, withFriction));
        }
        const double ofLoad = slides ? closest.friction.coefficient * closest.contact.force : 0.0;
        // Approach of the undeflected tip towards the tangent plane of the present closest point.
        const double approach = system_.tipRadius() - closest.foot.distance +
                                normal.dot(deflection_ - lever.offset) -
                                across * (closest.memory.friction - ofLoad);
        closest.contact =
            closest.timed.equilibrium(closest.model, approach, slides ? withFriction : along,
                                      closest.memory.contact, closest.contact.indentation);
        closest.memory.contact.coordinate = closest.contact.coordinate;
        closest.memory.friction = closest.frictionForce();
        closest.force = closest.contact.force * normal + closest.memory.friction * closest.slip;
        deflection_ = lever.offset + lever.compliance * closest.force;
        closest.foundAt = deflection_;
    }

    /// Two valleys' closest points may slide into one: it must not bear its force twice.
    void dropDoubledPoints() {
        for (std::size_t i = points_.size(); i-- > 1;) {
            if (isKnown(points_[i].foot, i)) {
                points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(i));
                beside_.forget();
            }
        }
    }

    void putMainPointFirst() {
        for (std::size_t i = 1; i < points_.size(); ++i) {
            if (std::abs(points_[i].contact.force) >
                kMainPoint * std::abs(points_[0].contact.force)) {
                std::swap(points_[0], points_[i]);
            }
        }
    }

    void report() {
        const TipContactPoint& main = points_.front();
        Vector3 normalForce = Vector3::Zero();
        state_.points = 0;
        for (const TipContactPoint& closest : points_) {
            const bool bears =
                std::abs(closest.contact.force) > kBears * std::abs(main.contact.force);
            state_.points += bears ? 1 : 0;
            normalForce += closest.contact.force * closest.foot.normal;
            state_.force += closest.force;
            state_.contactArea += closest.area();
            state_.contactRatio = std::max(state_.contactRatio,
                                           closest.contact.contactRadius / closest.radius.radius);
        }
        state_.points = std::max(1, state_.points);
        if (joined_ && state_.proof == SearchProof::Nearest) {
            state_.proof = SearchProof::TooManyPoints;
        }
        for (const TipContactPoint& closest : points_) {
            reportNeighbors(closest);
        }
        state_.tip = base_.position + deflection_;
        state_.closest = main.foot;
        state_.contact = main.contact;
        state_.body = main.model.bodyPull();
        state_.slip = main.slip;
        state_.effectiveRadius = main.radius.radius;
        state_.tipFits = main.radius.tipFits;
        state_.anisotropic = main.radius.anisotropic;
        state_.normal = main.foot.normal;
        state_.normalForce = main.contact.force;
        if (points_.size() > 1 && normalForce.norm() > 0.0) {
            const double sign = normalForce.dot(main.foot.normal) < 0.0 ? -1.0 : 1.0;
            state_.normalForce = sign * normalForce.norm();
            state_.normal = normalForce / state_.normalForce;
        }
    }

    /// Reports the other contacts' effect on one: a half-space sinks by N / (pi E* d) at a distance
    /// d from where it is pressed, and contacts nearer than that holds for are no two.
    void reportNeighbors(const TipContactPoint& closest) {
        if (points_.size() == 1 || !(closest.contact.contactRadius > 0.0)) {
            return;
        }
        double sunk = 0.0;
        for (const TipContactPoint& other : points_) {
            if (&other == &closest || !(other.contact.contactRadius > 0.0)) {
                continue;
            }
            const double apart = (other.foot.point - closest.foot.point).norm();
            state_.overlapping |= closest.reach() + other.reach() > apart;
            sunk += std::abs(other.contact.force) /
                    (std::numbers::pi * other.model.pair().reducedModulus * apart);
        }
        state_.interaction = std::max(state_.interaction, sunk / closest.depth());
    }

    /// Returns whether contacts that nobody knows of may hold the tip: where lever and sample have
    /// a bonded state beside the free one. Necks that share a lever tear off as one does on a lever
    /// as many times as soft.
    [[nodiscard]] bool mayBeHeld() const {
        const TipContactPoint& main = points_.front();
        const double along = main.foot.normal.dot(compliance_ * main.foot.normal);
        const double tearsOff = main.model.pullOffApproach(kMaxContactPoints * along);
        if (!(tearsOff < main.model.jumpInApproach(along))) {
            return false;
        }
        const bool isBonded =
            std::any_of(points_.begin(), points_.end(), [](const TipContactPoint& closest) {
                return closest.contact.branch == ContactBranch::Bonded;
            });
        return isBonded || main.contact.indentation + along * main.contact.force > tearsOff;
    }

    void remember(EquilibriumMemory& memory) const {
        memory.deflection = deflection_;
        memory.tip = state_.tip;
        memory.mayLackPoint = state_.mayLackPoint;
        memory.pointCount = 0;
        for (const TipContactPoint& closest : points_) {
            const bool isFar = closest.contact.branch == ContactBranch::Far &&
                               closest.foot.distance > bearsWithin();
            if (memory.pointCount > 0 && isFar) {
                continue;
            }
            memory.points[memory.pointCount++] = {
                .guess = closest.foot.guess(),
                .contact = closest.contact.memory(),
                .time = closest.timed.after(closest.model, closest.contact),
                .friction = closest.memory.friction};
        }
    }

    SampleSurface surface_;
    const ProbeSystem& system_;
    const BaseMotion& base_;
    const Matrix3& compliance_;
    double tolerance_;     ///< of the tip's position [m]
    double range_;         ///< across which a closest point attracts the tip [m]
    double margin_ = 0.0;  ///< beyond that range, of a look for closest points [m]
    ClosestPointTracker& tracker_;
    Vector3 deflection_ = Vector3::Zero();
    std::array<bool, kMaxContactPoints>
        taken_{};          ///< which of the remembered closest points have been found again
    bool joined_ = false;  ///< separate closest points count as one
    Vector3 lookedFrom_ =
        Vector3::Zero();       ///< the tip's center when closest points were last looked for
    double freeToMove_ = 0.0;  ///< from there, until another closest point may bear [m]
    boost::container::static_vector<TipContactPoint, kMaxContactPoints> points_;
    BesideContacts beside_;  ///< of these points
    TipState state_;
};

}  // namespace

TipState tipEquilibrium(const SampleSurface& surface, const ProbeSystem& system,
                        const BaseMotion& base, EquilibriumMemory& memory,
                        ClosestPointTracker& tracker) noexcept {
    if (!isWithinWorld(base.position)) {
        return nowhere();
    }
    return Balance(surface, system, base, system.cantilever.compliance(), tracker).solve(memory);
}

TipState tipEquilibrium(const SampleSurface& surface, const ProbeSystem& system,
                        const BaseMotion& base, EquilibriumMemory& memory) noexcept {
    ClosestPointTracker tracker;
    return tipEquilibrium(surface, system, base, memory, tracker);
}

TipState heldTip(const SampleSurface& surface, const ProbeSystem& system, const BaseMotion& tip,
                 const EquilibriumMemory& memory, ClosestPointTracker& tracker) noexcept {
    if (!isWithinWorld(tip.position)) {
        return nowhere();
    }
    EquilibriumMemory held = memory;
    held.deflection.setZero();
    held.tip = tip.position;
    const Matrix3 rigid = Matrix3::Zero();
    return Balance(surface, system, tip, rigid, tracker).solve(held);
}

TipState heldTip(const SampleSurface& surface, const ProbeSystem& system, const BaseMotion& tip,
                 const EquilibriumMemory& memory) noexcept {
    ClosestPointTracker tracker;
    return heldTip(surface, system, tip, memory, tracker);
}

}  // namespace asperity
