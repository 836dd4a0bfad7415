#include "core/probe/BesideContacts.h"

#include "core/surface/HeightMoments.h"

#include <boost/container/static_vector.hpp>

namespace asperity {

namespace {

constexpr double kLineError = 2e-4;  // of attraction beside the contact, as a share of pull-off
constexpr double kFarOff = 100.0;    // times that error, while the tip still moves
constexpr double kSoftest = 0.1;     // of a lever's stiffness that attraction beside it leaves

}  // namespace

void BesideContacts::sum(std::span<const TipContactPoint> points, const Vector3& tip) noexcept {
    if (!attracts_) {
        return;
    }
    boost::container::static_vector<Vector3, kMaxContactPoints> places;
    for (const TipContactPoint& closest : points) {
        places.push_back(closest.place.point);
    }
    const TipContactPoint& main = points.front();
    const BodyTraction traction = bodyTraction(system_, main.model.pair());
    force_ = bodyForce(*system_.beside, traction, tip, {places.data(), places.size()},
                       main.place.normal);
    error_ = kLineError * traction.pullOff;
}

bool BesideContacts::follow(std::span<const TipContactPoint> points, const Vector3& tip) noexcept {
    if (!attracts_ || (force_ && force_->holdsAt(tip, error_))) {
        return false;
    }
    sum(points, tip);
    return true;
}

Vector3 BesideContacts::likelyTip(const TipContactPoint& main, const Vector3& tip,
                                  const Vector3& before) const noexcept {
    if (!attracts_ || main.memory.contact.branch != ContactBranch::Bonded ||
        main.place.distance <= 0.0) {
        return tip;
    }
    const SearchGuess& guess = main.memory.guess;
    const double height = system_.beside->surface().at(guess.x, guess.y).height;
    const Vector3 arm = before - Vector3(guess.x, guess.y, height - system_.tipRadius());
    return tip + (arm.norm() - main.place.distance) * main.place.normal;
}

void BesideContacts::pull(std::span<TipContactPoint> points, const Vector3& tip,
                          double compliance) noexcept {
    if (!force_) {
        return;
    }
    // A line leads far astray where the tip jumps, or nothing was known of its place.
    if (!force_->holdsAt(tip, kFarOff * error_)) {
        sum(points, tip);
    }
    TipContactPoint& main = points.front();
    const double indentation = system_.tipRadius() - main.place.distance;
    BodyPull line = force_->along(main.place.normal, tip, indentation);
    // Attraction that outruns the lever ends at the contact, to which it falls step by step.
    if (compliance * line.slope < kSoftest - 1.0) {
        const double gentle = (kSoftest - 1.0) / compliance;
        line = {.force = line.at(indentation) - (gentle * indentation), .slope = gentle};
    }
    main.model.setBodyPull(line);
}

}  // namespace asperity
