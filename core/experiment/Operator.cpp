#include "core/experiment/Operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kFrameTime = 1.0 / 60.0;  // of the window [s]
constexpr double kAdaptation = 0.3;        // in which a hand gets used to a force [s]

constexpr double kLookTime = 0.05;  // between two looks while checking [s]

/// Share of the way after a share of the time: no jump of position, speed or acceleration.
double minimumJerk(double t) {
    const double time = std::clamp(t, 0.0, 1.0);
    return time * time * time * (10.0 + time * (6.0 * time - 15.0));
}

}  // namespace

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

OperatorSight::OperatorSight(const OperatorTraits& person, double scale, const Vector3& lineOfSight)
    : person_(person)
    , scale_(scale)
    , lineOfSight_(lineOfSight)
    , length_(static_cast<std::size_t>(std::ceil(person.sightTime / kFrameTime)) + 1) {
    frames_.reserve(length_);
}

void OperatorSight::show(const ShownMoment& moment, double timeStep) {
    sinceFrame_ += timeStep;
    if (!frames_.empty() && sinceFrame_ < kFrameTime) {
        return;
    }
    sinceFrame_ = 0.0;
    if (frames_.size() < length_) {
        frames_.push_back(moment);
        newest_ = frames_.size() - 1;
    } else {
        newest_ = (newest_ + 1) % frames_.size();
        frames_[newest_] = moment;
    }
}

/// The oldest frame that is kept.
const ShownMoment& OperatorSight::seen() const {
    return frames_.size() < length_ ? frames_.front() : frames_[(newest_ + 1) % frames_.size()];
}

Vector3 OperatorSight::look(Random& random) const {
    const ShownMoment& moment = seen();
    const double sigma = person_.acuity / scale_ * (moment.hidden ? person_.hiddenFactor : 1.0);
    Vector3 error(random.normal(), random.normal(), random.normal());
    error += (person_.depthFactor - 1.0) * error.dot(lineOfSight_) * lineOfSight_;
    return moment.tip + sigma * error;
}

void OperatorTouch::feel(const Vector3& force, double timeStep) {
    if (since_ >= 0.0) {
        since_ += timeStep;
        noticed_ = noticed_ || since_ >= person_.touchTime;
    }
    const double least = std::max(person_.leastForce, person_.forceShare * usual_.norm());
    if (since_ < 0.0 && (force - usual_).norm() > least) {
        since_ = 0.0;
    }
    usual_ += std::min(1.0, timeStep / kAdaptation) * (force - usual_);
}

bool OperatorTouch::takeNotice() {
    if (!noticed_) {
        return false;
    }
    noticed_ = false;
    since_ = -1.0;
    return true;
}

Operator::Operator(const OperatorTraits& person, const OperatorTask& task, const Vector3& hand,
                   std::uint64_t seed)
    : person_(person)
    , task_(task)
    , random_(seed)
    , sight_(person, task.screenScale, task.lineOfSight)
    , touch_(person)
    , hand_(hand)
    , from_(hand)
    , to_(hand) {}

void Operator::begin() { enter(Phase::Looking); }

void Operator::enter(Phase phase) {
    phase_ = phase;
    inPhase_ = 0.0;
}

Vector3 Operator::advance(double timeStep) {
    inPhase_ += timeStep;
    if (phase_ != Phase::Resting) {
        sinceBegin_ += timeStep;
    }
    switch (phase_) {
    case Phase::Resting:
    case Phase::Pressed:
        break;
    case Phase::Looking:
        if (inPhase_ >= person_.sightTime) {
            decide();
        }
        break;
    case Phase::Moving:
        hand_ = from_ + minimumJerk(inPhase_ / duration_) * (to_ - from_);
        if (touch_.takeNotice() || inPhase_ >= duration_) {
            enter(Phase::Looking);
        }
        break;
    case Phase::Checking:
        sinceLook_ += timeStep;
        check();
        break;
    case Phase::Pressing:
        if (inPhase_ >= person_.pressTime) {
            enter(Phase::Pressed);
        }
        break;
    }
    return hand_ + trembled(timeStep);
}

/// From the tip, as it is seen, to the target [m].
Vector3 Operator::missing() { return task_.target - sight_.look(random_); }

double Operator::tolerance() const {
    return person_.tolerance / task_.screenScale * (1.0 + sinceBegin_ / person_.patience);
}

void Operator::decide() {
    const Vector3 way = missing();
    if (way.norm() <= tolerance()) {
        sinceLook_ = 0.0;
        enter(Phase::Checking);
    } else {
        move(way);
    }
}

void Operator::check() {
    if (sinceLook_ < kLookTime) {
        return;
    }
    sinceLook_ = 0.0;
    const Vector3 way = missing();
    if (way.norm() > 1.5 * tolerance()) {
        move(way);
    } else if (inPhase_ >= person_.dwell) {
        enter(Phase::Pressing);
    }
}

void Operator::move(const Vector3& way) {
    const Vector3 handWay = way / task_.positionGain;
    const double length = handWay.norm();
    const Vector3 error(random_.normal(), random_.normal(), random_.normal());
    from_ = hand_;
    to_ = hand_ + handWay + person_.aimError * length * error;
    duration_ = timeFor(way.norm());
    ++movements_;
    (void)touch_.takeNotice();  // what was felt before is over
    enter(Phase::Moving);
}

/// Fitts' law; the target is as wide as the person is content with on both sides.
double Operator::timeFor(double length) const {
    constexpr double kShortest = 0.15;  // [s]
    const double bits = std::log2(length / tolerance() + 1.0);
    return std::max(kShortest, person_.moveTime + person_.timePerBit * bits);
}

/// Noise through a resonance, whose root mean square is the person's tremor.
Vector3 Operator::trembled(double timeStep) {
    constexpr double kDamping = 0.1;  // of critical
    const double omega = 2.0 * std::numbers::pi * person_.tremorRate;
    const double drive = person_.tremor * omega * std::sqrt(4.0 * kDamping * omega / timeStep);
    const Vector3 noise(random_.normal(), random_.normal(), random_.normal());
    const Vector3 acceleration =
        drive * noise - 2.0 * kDamping * omega * trembleSpeed_ - omega * omega * tremble_;
    trembleSpeed_ += timeStep * acceleration;
    tremble_ += timeStep * trembleSpeed_;
    return tremble_;
}

DeviceState OperatedBench::advance(double timeStep) noexcept {
    timeStep_ = timeStep;
    operator_.feel(force_, timeStep);
    bench_.reachFor(operator_.advance(timeStep));
    return bench_.advance(timeStep);
}

void OperatedBench::setForce(const Vector3& force) noexcept {
    force_ = force;
    bench_.setForce(force);
}

void OperatedBench::observe(const TickOutput& output) noexcept {
    const bool isInside = output.model.contact.indentation > 0.0;
    operator_.see({.tip = output.model.tip, .hidden = isInside && !deformationShown_}, timeStep_);
}

}  // namespace asperity
