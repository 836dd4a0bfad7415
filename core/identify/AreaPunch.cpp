#include "core/identify/AreaPunch.h"

#include "core/Error.h"
#include "core/contact/numerics/RootSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

AreaPunch::AreaPunch(const std::vector<AreaSample>& samples) {
    AreaSample last;  // the apex
    for (const AreaSample& sample : samples) {
        if (sample.height == 0.0 && sample.area == 0.0) {
            continue;
        }
        const double square = (sample.area - last.area) / std::numbers::pi;
        const double rise = sample.height - last.height;
        if (!(square > 0.0) || !(rise > 0.0)) {
            // Heights that measurement noise brought out of order tell nothing.
            if (sample.height < last.height) {
                throw Error("the heights of an area function must rise from row to row");
            }
            continue;
        }
        const double inner = last.area / std::numbers::pi;
        rings_.push_back({.radius = std::sqrt(inner), .square = inner, .rise = rise / square});
        last = sample;
    }
    if (rings_.size() < 2) {
        throw Error("an area function needs at least two rows of rising height and area");
    }
    height_ = last.height;
}

/// Over a ring the height rises as m r^2, so that with q = sqrt(a^2 - r^2) the integrals of
/// f' / q and r^2 f' / q end in -2 m q and -2 m (a^2 q - q^3 / 3).
IndentationPoint AreaPunch::ofRadius(double contactRadius) const noexcept {
    const double a = contactRadius;
    const double square = a * a;
    double depth = 0.0;
    double force = 0.0;
    for (std::size_t i = 0; i < rings_.size() && rings_[i].radius < a; ++i) {
        const bool isLast = i + 1 == rings_.size() || rings_[i + 1].radius >= a;
        const double inner = std::sqrt(square - rings_[i].square);
        const double outer = isLast ? 0.0 : std::sqrt(square - rings_[i + 1].square);
        const double first = inner - outer;
        const double third = (inner * inner * inner) - (outer * outer * outer);
        depth += rings_[i].rise * first;
        force += rings_[i].rise * ((square * first) - (third / 3.0));
    }
    return {.force = 4.0 * force,
            .stiffness = 2.0 * a,
            .contactRadius = a,
            .indentation = 2.0 * a * depth};
}

IndentationPoint AreaPunch::at(double indentation) const noexcept {
    double high = std::max(rings_.back().radius, 1e-12);
    while (ofRadius(high).indentation < indentation) {
        high *= 2.0;
    }
    const double radius =
        rootBetween([&](double a) { return ofRadius(a).indentation - indentation; }, 0.0, high);
    return ofRadius(radius);
}

}  // namespace asperity
