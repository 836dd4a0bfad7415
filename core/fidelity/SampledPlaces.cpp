#include "core/fidelity/SampledPlaces.h"

#include "core/contact/EffectiveRadius.h"
#include "core/haptics/DevicePath.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/ContactHeight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace asperity {

namespace {

/// Pixels along an axis that are looked at: a scan of usual size is looked at in full.
constexpr int kMostAcross = 256;
/// Of the scan's side: nearer to its edge a run has no room.
constexpr double kEdge = 0.02;
/// Positions whose features differ by less look alike: an error of 1 % is known to half of itself
/// by a position whose radius, and with it the pull-off, differs by as much.
constexpr double kAlike = 0.005;

/// What decides how a contact at a position differs from others.
enum Feature : std::size_t { Radius, SlopeX, SlopeY, Modulus, Adhesion, FeatureCount };

/// A point of the sample with the position of the base at which the tip touches it.
struct Touch {
    Vector2 base;         ///< world [m]
    double center = 0.0;  ///< height of the tip's center [m]
    std::array<double, FeatureCount> features{};
};

bool lookAlike(const Touch& a, const Touch& b) {
    const auto ratioDiffers = [&](Feature feature) {
        return std::abs(a.features[feature] - b.features[feature]) >
               kAlike * std::max(std::abs(a.features[feature]), std::abs(b.features[feature]));
    };
    const auto slopeDiffers = [&](Feature feature) {
        return std::abs(a.features[feature] - b.features[feature]) > kAlike;
    };
    return !ratioDiffers(Radius) && !ratioDiffers(Modulus) && !ratioDiffers(Adhesion) &&
           !slopeDiffers(SlopeX) && !slopeDiffers(SlopeY);
}

/// All that the tip could touch, and the sharpest hollow that it does not fit.
class Touches {
public:
    explicit Touches(const Scene& scene) : scene_(scene), radius_(scene.belief.tipRadius()) {
        const BSplineSurface::Grid& grid = scene.surface.grid();
        const int stepX = 1 + (grid.columns - 1) / kMostAcross;
        const int stepY = 1 + (grid.rows - 1) / kMostAcross;
        for (int row = stepY / 2; row < grid.rows; row += stepY) {
            for (int column = stepX / 2; column < grid.columns; column += stepX) {
                look((column + 0.5) * grid.pitchX, (row + 0.5) * grid.pitchY);
            }
        }
    }

    [[nodiscard]] const std::vector<Touch>& all() const noexcept { return all_; }
    [[nodiscard]] const std::optional<Vector2>& hollow() const noexcept { return hollow_; }

    /// The point of the sample below a position [m].
    [[nodiscard]] Touch at(const Vector2& place, const HeightSample& sample,
                           double effectiveRadius) const {
        const Vector3 toCenter = radius_ * sample.normal();
        const PlaceMaterial material = materialAt(place);
        return {.base = place + toCenter.head<2>(),
                .center = sample.height + toCenter.z(),
                .features = {effectiveRadius, sample.dx, sample.dy, material.youngsModulus,
                             material.workOfAdhesion}};
    }

    /// Whether no other part of the sample keeps the tip from there.
    [[nodiscard]] bool isReached(const Touch& touch) const {
        constexpr double kOfRadius = 1e-3;
        return tipContactHeight(scene_.surface, touch.base.x(), touch.base.y(), radius_) -
                   touch.center <
               kOfRadius * radius_;
    }

private:
    void look(double x, double y) {
        const HeightSample sample = scene_.surface.at(x, y);
        const PrincipalCurvatures bend = principalCurvatures(sample);
        const EffectiveRadius effective = effectiveRadius(radius_, bend.largest, bend.smallest);
        const Vector2 place(x, y);
        if (!effective.tipFits && isInside(place) && bend.smallest < sharpest_) {
            sharpest_ = bend.smallest;
            hollow_ = place;
        }
        const Touch touch = at(place, sample, effective.radius);
        if (effective.tipFits && isInside(touch.base)) {
            all_.push_back(touch);
        }
    }

    [[nodiscard]] bool isInside(const Vector2& place) const {
        const auto isBetween = [](double coordinate, double size) {
            return coordinate >= kEdge * size && coordinate <= (1.0 - kEdge) * size;
        };
        return isBetween(place.x(), scene_.surface.sizeX()) &&
               isBetween(place.y(), scene_.surface.sizeY()) &&
               scene_.surface.isMeasured(place.x(), place.y());
    }

    [[nodiscard]] PlaceMaterial materialAt(const Vector2& place) const {
        return scene_.belief.field ? scene_.belief.field->at(place.x(), place.y())
                                   : PlaceMaterial{};
    }

    const Scene& scene_;
    double radius_;  ///< of the tip [m]
    std::vector<Touch> all_;
    std::optional<Vector2> hollow_;  ///< world [m]
    double sharpest_ = 0.0;          ///< curvature there [1/m]
};

/// The positions chosen so far, without two that look alike.
class Chosen {
public:
    explicit Chosen(const Touches& touches) : touches_(touches) {}

    /// Of all touches in the order of a feature those with these shares of the others before them;
    /// where the tip does not reach one, the next one towards the middle that it does.
    void takeSpread(Feature feature, std::span<const double> shares) {
        std::vector<const Touch*> order;
        for (const Touch& touch : touches_.all()) {
            order.push_back(&touch);
        }
        std::ranges::stable_sort(
            order, {}, [feature](const Touch* touch) { return touch->features.at(feature); });
        for (const double share : shares) {
            takeReached(order, share);
        }
    }

    void take(const Touch& touch) {
        if (std::ranges::none_of(taken_, [&](const Touch& t) { return lookAlike(t, touch); })) {
            taken_.push_back(touch);
        }
    }

    [[nodiscard]] std::vector<Vector2> places() const {
        std::vector<Vector2> places;
        for (const Touch& touch : taken_) {
            places.push_back(touch.base);
        }
        return places;
    }

private:
    /// On a rough sample most of the extremes are out of reach: steps grow.
    void takeReached(const std::vector<const Touch*>& order, double share) {
        constexpr int kTries = 32;
        for (int i = 0; i < kTries; ++i) {
            const double now = share + ((0.5 - share) * i * i / (kTries * kTries));
            const double rank = now * static_cast<double>(order.size() - 1);
            const Touch& found = *order[static_cast<std::size_t>(std::lround(rank))];
            if (touches_.isReached(found)) {
                take(found);
                return;
            }
        }
    }

    const Touches& touches_;
    std::vector<Touch> taken_;
};

void takeSpread(const Scene& scene, Chosen& chosen) {
    constexpr std::array kOrder{0.0, 1.0, 0.5, 0.25, 0.75};  // extremes first: they stay
    constexpr std::array kExtremes{0.0, 1.0};
    chosen.takeSpread(Radius, kOrder);
    chosen.takeSpread(SlopeX, kExtremes);
    chosen.takeSpread(SlopeY, kExtremes);
    if (scene.belief.field) {
        chosen.takeSpread(Modulus, kExtremes);
        chosen.takeSpread(Adhesion, kExtremes);
    }
}

}  // namespace

std::vector<Vector2> sampledPlaces(const Scene& scene) {
    const Touches touches(scene);
    Chosen chosen(touches);
    if (!touches.all().empty()) {
        takeSpread(scene, chosen);
    }
    const Vector2 top = pathStart(scene, {}).head<2>();
    const HeightSample sample = scene.surface.at(top.x(), top.y());
    const PrincipalCurvatures bend = principalCurvatures(sample);
    chosen.take(
        touches.at(top, sample,
                   effectiveRadius(scene.belief.tipRadius(), bend.largest, bend.smallest).radius));
    std::vector<Vector2> places = chosen.places();
    if (touches.hollow()) {
        places.push_back(*touches.hollow());
    }
    return places;
}

}  // namespace asperity
