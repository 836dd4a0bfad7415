#include "core/probe/TipEquilibrium.h"

#include "core/contact/EffectiveRadius.h"
#include "core/contact/Within.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/Sliding.h"
#include "core/surface/foot/TipFeet.h"
#include "core/surface/touched/TouchedSurface.h"

#include <Eigen/LU>

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

constexpr int kMaxSweeps = 48;
constexpr double kPositionTolerance =
    1e-15;                            // [m]: a millionth of an atom's radius, above rounding
constexpr double kSameRadius = 1e-6;  // relative change of R_eff that needs no new solution
constexpr double kFlatEnough = 0.1;   // relative change of R_eff that a flat sample may stand for
constexpr double kReach = 10e-9;      // [m]: attraction across a wider gap is below a piconewton
constexpr double kSameSlot = 0.25;    // of the tip's radius: a foot moves less from tick to tick
constexpr double kMainFoot = 1.5;     // another foot becomes the main one with so much more force
constexpr double kBears = 1e-3;       // share of the main foot's force from which a foot counts

/// One foot with the contact law of its place and the force it bears.
struct Foot {
    SurfaceFoot place;
    FootMemory memory;
    ContactModel model;
    EffectiveRadius radius;
    ContactState contact;
    Vector3 slip = Vector3::Zero();
    Vector3 force = Vector3::Zero();  ///< on the tip, lab frame [N]

    [[nodiscard]] double stiffness() const { return std::max(0.0, contact.stiffness); }
};

/// Whether a place is one from where the contact laws can be asked, whatever lies below it.
bool isPlace(const Vector3& position) {
    constexpr double kFarthest = 500.0;  // [m]
    return isWithin(position.x(), -kFarthest, kFarthest) &&
           isWithin(position.y(), -kFarthest, kFarthest) &&
           isWithin(position.z(), -kFarthest, kFarthest);
}

TipState nowhere() {
    TipState state;
    state.contact.status = ContactStatus::ApproachOutOfRange;
    return state;
}

double areaOf(const ContactState& contact) {
    return std::numbers::pi * contact.contactRadius * contact.contactRadius;
}

double frictionForce(const Friction& friction, const ContactState& contact) {
    const double area = areaOf(contact);
    if (area <= 0.0) {
        return 0.0;
    }  // nothing touches
    return std::max(0.0, friction.coefficient * contact.force + friction.shearStrength * area);
}

/// A sphere against a curved surface is no sphere against a flat one where the contact is about as
/// wide as the tip: the exact-sphere laws take the sample as flat.
EffectiveRadius takenAsFlat(EffectiveRadius curved, double tipRadius) {
    const bool isCurved = std::abs(curved.radius - tipRadius) > kFlatEnough * tipRadius;
    return {.radius = tipRadius, .fits = curved.fits, .elongated = curved.elongated || isCurved};
}

/// Search for the tip's place between a lever of given compliance and all its feet, one foot at a
/// time while the others answer to first order.
class Balance {
public:
    Balance(const TouchedSurface& surface, const ProbeSystem& system, const BaseMotion& base,
            const Matrix3& compliance)
        : surface_(surface), system_(system), base_(base), compliance_(compliance) {}

    TipState solve(EquilibriumMemory& memory) {
        deflection_ = memory.deflection;
        findFeet(memory);
        for (int i = 0; i < kMaxSweeps && !state_.converged; ++i) {
            const Vector3 before = deflection_;
            state_.locked = false;
            for (Foot& foot : feet_) {
                settle(foot);
            }
            dropDoubledFeet();
            const bool still = (deflection_ - before).norm() <= kPositionTolerance;
            state_.converged = still && !followCurvature() && !findMoreFeet(memory);
        }
        putMainFootFirst();
        report();
        remember(memory);
        return state_;
    }

private:
    /// The lever as one foot meets it: stiffened by the other feet, and moved by them.
    struct Lever {
        Matrix3 compliance;
        Vector3 offset;  ///< of the tip when the foot bears no force [m]
    };

    [[nodiscard]] Vector3 center() const {
        return base_.position + deflection_ + Vector3(0.0, 0.0, system_.tipRadius());
    }

    void findFeet(EquilibriumMemory& memory) {
        boost::container::static_vector<FootGuess, kMaxFeet> known;
        for (std::size_t i = 0; i < memory.footCount; ++i) {
            known.push_back(memory.feet[i].guess);
        }
        addFeet({known.data(), known.size()}, memory);
        followCurvature();
    }

    /// Where the tip has moved by much since the last look, there may be feet that nobody saw.
    bool findMoreFeet(EquilibriumMemory& memory) {
        if ((center() - lookedFrom_).norm() <= kSameFoot * system_.tipRadius()) {
            return false;
        }
        boost::container::static_vector<FootGuess, kMaxFeet> known;
        for (const Foot& foot : feet_) {
            known.push_back(foot.place.guess());
        }
        const std::size_t before = feet_.size();
        addFeet({known.data(), known.size()}, memory);
        followCurvature();
        return feet_.size() > before;
    }

    void addFeet(std::span<const FootGuess> known, EquilibriumMemory& memory) {
        lookedFrom_ = center();
        const TipFeet found =
            surface_.tipFeet({lookedFrom_, system_.tipRadius()}, kReach, known, memory.tracker);
        state_.proof = found.proof;
        for (const SurfaceFoot& place : found.list.all()) {
            if (feet_.size() < kMaxFeet && !isKnown(place, feet_.size())) {
                feet_.push_back({.place = place,
                                 .memory = takeMemory(place, memory),
                                 .model = system_.contact,
                                 .radius = {},
                                 .contact = {}});
            }
        }
    }

    /// Whether one of the first `count` feet stands there.
    [[nodiscard]] bool isKnown(const SurfaceFoot& place, std::size_t count) const {
        const double same = kSameFoot * system_.tipRadius();
        return std::any_of(
            feet_.begin(), feet_.begin() + static_cast<std::ptrdiff_t>(count),
            [&](const Foot& foot) { return (foot.place.point - place.point).norm() <= same; });
    }

    /// What was known of a foot: of the nearest one remembered that no other foot has taken. The
    /// first foot is always known.
    [[nodiscard]] FootMemory takeMemory(const SurfaceFoot& place, const EquilibriumMemory& memory) {
        std::size_t best = feet_.empty() ? 0 : memory.footCount;
        double nearest = kSameSlot * system_.tipRadius();
        for (std::size_t i = 0; i < memory.footCount; ++i) {
            const FootGuess& guess = memory.feet[i].guess;
            const double away = std::hypot(guess.x - place.point.x(), guess.y - place.point.y());
            if (!taken_[i] && away < nearest) {
                nearest = away;
                best = i;
            }
        }
        if (best >= memory.footCount) {
            return {};
        }
        taken_[best] = true;
        return memory.feet[best];
    }

    [[nodiscard]] EffectiveRadius radiusAt(const SurfaceFoot& place) const {
        const PrincipalCurvatures bend =
            system_.curvature ? place.curvatures : PrincipalCurvatures{};
        return effectiveRadius(system_.tipRadius(), bend.largest, bend.smallest);
    }

    /// Gives each foot the effective radius of its place; whether one of them changed.
    bool followCurvature() {
        bool changed = false;
        for (Foot& foot : feet_) {
            foot.radius = radiusAt(foot.place);
            if (isSphere(system_.contact.law())) {
                foot.radius = takenAsFlat(foot.radius, system_.tipRadius());
            }
            const double used = foot.model.pair().tipRadius;
            if (std::abs(foot.radius.radius - used) > kSameRadius * used) {
                foot.model = system_.contact.withTipRadius(foot.radius.radius);
                changed = true;
            }
        }
        return changed;
    }

    [[nodiscard]] Lever leverOf(const Foot& foot) const {
        if (feet_.size() == 1) {
            return {compliance_, Vector3::Zero()};
        }
        Matrix3 stiffness = Matrix3::Zero();
        Vector3 force = Vector3::Zero();
        for (const Foot& other : feet_) {
            if (&other != &foot) {
                const Vector3& normal = other.place.normal;
                stiffness += other.stiffness() * normal * normal.transpose();
                force += other.force;
            }
        }
        const Matrix3 stiffened =
            (Matrix3::Identity() + compliance_ * stiffness).inverse() * compliance_;
        return {stiffened, stiffened * (force + stiffness * deflection_)};
    }

    /// Balances lever and contact at one foot.
    void settle(Foot& foot) {
        foot.place = surface_.localFoot(center(), foot.place.guess());
        const Vector3& normal = foot.place.normal;
        foot.slip = slidingOf(normal, base_.velocity).slip();
        const Lever lever = leverOf(foot);
        const double along = normal.dot(lever.compliance * normal);
        const double across = normal.dot(lever.compliance * foot.slip);
        const double withFriction = along + system_.friction.coefficient * across;
        // Friction that drags the tip deeper faster than the lever lifts it locks it.
        const bool locks = along > 0.0 && withFriction <= 0.0;
        state_.locked |= locks;
        // The part mu N of friction is solved with N, as a change of the lever's compliance
        // (1 / k_n of docs/theory.md 7.2); the rest, of the area, is that of the last sweep.
        const bool slides = foot.memory.friction > 0.0 && !locks;
        const double ofLoad = slides ? system_.friction.coefficient * foot.contact.force : 0.0;
        // Approach of the undeflected tip towards the tangent plane of the present foot.
        const double approach = system_.tipRadius() - foot.place.distance +
                                normal.dot(deflection_ - lever.offset) -
                                across * (foot.memory.friction - ofLoad);
        foot.contact =
            foot.model.equilibrium(approach, slides ? withFriction : along, foot.memory.contact);
        foot.memory.contact.coordinate = foot.contact.coordinate;
        foot.memory.friction = frictionForce(system_.friction, foot.contact);
        foot.force = foot.contact.force * normal + foot.memory.friction * foot.slip;
        deflection_ = lever.offset + lever.compliance * foot.force;
    }

    /// Two valleys' feet may slide into one: it must not bear its force twice.
    void dropDoubledFeet() {
        for (std::size_t i = feet_.size(); i-- > 1;) {
            if (isKnown(feet_[i].place, i)) {
                feet_.erase(feet_.begin() + static_cast<std::ptrdiff_t>(i));
            }
        }
    }

    void putMainFootFirst() {
        for (std::size_t i = 1; i < feet_.size(); ++i) {
            if (std::abs(feet_[i].contact.force) > kMainFoot * std::abs(feet_[0].contact.force)) {
                std::swap(feet_[0], feet_[i]);
            }
        }
    }

    void report() {
        const Foot& main = feet_.front();
        Vector3 normalForce = Vector3::Zero();
        state_.feet = 0;
        for (const Foot& foot : feet_) {
            const bool bears = std::abs(foot.contact.force) > kBears * std::abs(main.contact.force);
            state_.feet += bears ? 1 : 0;
            normalForce += foot.contact.force * foot.place.normal;
            state_.force += foot.force;
            state_.contactArea += areaOf(foot.contact);
            state_.contactRatio =
                std::max(state_.contactRatio, foot.contact.contactRadius / foot.radius.radius);
        }
        state_.feet = std::max(1, state_.feet);
        state_.tip = base_.position + deflection_;
        state_.foot = main.place;
        state_.contact = main.contact;
        state_.slip = main.slip;
        state_.effectiveRadius = main.radius.radius;
        state_.fits = main.radius.fits;
        state_.radiusIsRough = main.radius.elongated;
        state_.normal = main.place.normal;
        state_.normalForce = main.contact.force;
        if (feet_.size() > 1 && normalForce.norm() > 0.0) {
            const double sign = normalForce.dot(main.place.normal) < 0.0 ? -1.0 : 1.0;
            state_.normalForce = sign * normalForce.norm();
            state_.normal = normalForce / state_.normalForce;
        }
    }

    void remember(EquilibriumMemory& memory) const {
        memory.deflection = deflection_;
        memory.footCount = 0;
        for (const Foot& foot : feet_) {
            const bool isFar = foot.contact.branch == ContactBranch::Far &&
                               foot.place.distance > system_.tipRadius() + kReach;
            if (memory.footCount > 0 && isFar) {
                continue;
            }
            memory.feet[memory.footCount++] = {.guess = foot.place.guess(),
                                               .contact = foot.contact.memory(),
                                               .friction = foot.memory.friction};
        }
    }

    TouchedSurface surface_;
    const ProbeSystem& system_;
    const BaseMotion& base_;
    const Matrix3& compliance_;
    Vector3 deflection_ = Vector3::Zero();
    std::array<bool, kMaxFeet> taken_{};   ///< which of the remembered feet have been found again
    Vector3 lookedFrom_ = Vector3::Zero();  ///< the tip's center when feet were last looked for
    boost::container::static_vector<Foot, kMaxFeet> feet_;
    TipState state_;
};

}  // namespace

TipState tipEquilibrium(const TouchedSurface& surface, const ProbeSystem& system,
                        const BaseMotion& base, EquilibriumMemory& memory) noexcept {
    if (!isPlace(base.position)) {
        return nowhere();
    }
    return Balance(surface, system, base, system.cantilever.compliance()).solve(memory);
}

TipState heldTip(const TouchedSurface& surface, const ProbeSystem& system, const BaseMotion& tip,
                 const EquilibriumMemory& memory) noexcept {
    if (!isPlace(tip.position)) {
        return nowhere();
    }
    EquilibriumMemory held = memory;
    held.deflection.setZero();
    const Matrix3 rigid = Matrix3::Zero();
    return Balance(surface, system, tip, rigid).solve(held);
}

}  // namespace asperity
