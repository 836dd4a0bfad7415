#include "core/Error.h"
#include "core/Random.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {

namespace {

/// How often a radius or a place is drawn before giving up.
constexpr int kMaxDraws = 10000;

double drawRadius(const Nanoparticles::Recipe& recipe, Random& random) {
    for (int draw = 0; draw < kMaxDraws; ++draw) {
        const double radius = recipe.medianRadius * std::exp(recipe.spread * random.normal());
        if (radius >= recipe.smallest && radius <= recipe.largest) {
            return radius;
        }
    }
    throw Error("hardly any particle radius falls between the minimum and the maximum");
}

}  // namespace

Nanoparticles::Nanoparticles(const Recipe& recipe, const ScanSize& size) : recipe_(recipe) {
    if (recipe.count < 0 || !(recipe.medianRadius > 0.0) || !(recipe.smallest > 0.0) ||
        !(recipe.scanTipRadius >= 0.0)) {
        throw Error("particles need a positive radius");
    }
    Random random(recipe.seed);
    for (int i = 0; i < recipe.count; ++i) {
        Particle particle{.radius = drawRadius(recipe, random)};
        const double margin = outlineRadius(particle.radius) + recipe.clearance;
        bool placed = false;
        for (int draw = 0; draw < kMaxDraws && !placed; ++draw) {
            particle.x = random.uniform(margin, size.sizeX - margin);
            particle.y = random.uniform(margin, size.sizeY - margin);
            placed = 2.0 * margin < std::min(size.sizeX, size.sizeY) && hasRoom(particle);
        }
        if (!placed) {
            throw Error("there is no room for " + std::to_string(recipe.count) + " particles");
        }
        particles_.push_back(particle);
    }
}

/// Half the width at which a particle stands out: where the tip touches particle and plane at once,
/// or where it slides off the equator of a particle larger than itself.
double Nanoparticles::outlineRadius(double particleRadius) const {
    const double tip = recipe_.scanTipRadius;
    return tip < particleRadius ? particleRadius + tip : 2.0 * std::sqrt(particleRadius * tip);
}

bool Nanoparticles::hasRoom(const Particle& particle) const {
    return std::ranges::all_of(particles_, [&](const Particle& other) {
        return std::hypot(particle.x - other.x, particle.y - other.y) >
               outlineRadius(particle.radius) + outlineRadius(other.radius) + recipe_.clearance;
    });
}

double Nanoparticles::height(double x, double y) const {
    double height = 0.0;
    for (const Particle& particle : particles_) {
        const double distance = std::hypot(x - particle.x, y - particle.y);
        if (distance > outlineRadius(particle.radius)) {
            continue;
        }
        const double reach = particle.radius + recipe_.scanTipRadius;
        const double center = particle.radius + std::sqrt((reach - distance) * (reach + distance));
        height = std::max(height, center - recipe_.scanTipRadius);
    }
    return height;
}

}  // namespace asperity
