#include "core/deformation/SurfaceField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace asperity {

SurfaceField::SurfaceField(SurfaceQuantity quantity, std::shared_ptr<const PixelField> pixels,
                           std::string name)
    : quantity_(quantity), pixels_(std::move(pixels)), name_(std::move(name)) {}

SurfaceField::SurfaceField(SurfaceQuantity quantity, std::shared_ptr<const RegionField> region,
                           std::string name)
    : quantity_(quantity), region_(std::move(region)), name_(std::move(name)) {}

std::string SurfaceField::name() const { return name_.empty() ? nameOf(quantity_) : name_; }

std::string SurfaceField::unit() const {
    if (region_ != nullptr) {
        return region_->unit();
    }
    return pixels_ != nullptr ? pixels_->unit() : rowOf(quantity_)->unit;
}

double SurfaceField::at(const Vector3& rest, const Vector3& normal) const noexcept {
    constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
    switch (quantity_) {
    case SurfaceQuantity::Height:
        return rest.z();
    case SurfaceQuantity::Slope:
        return std::atan2(std::hypot(normal.x(), normal.y()), normal.z());
    case SurfaceQuantity::Pressure:
    case SurfaceQuantity::Displacement:
        return 0.0;
    case SurfaceQuantity::Residual:
    case SurfaceQuantity::YoungsModulus:
    case SurfaceQuantity::WorkOfAdhesion:
    case SurfaceQuantity::FrictionCoefficient:
    case SurfaceQuantity::Channel:
        return pixels_ != nullptr ? pixels_->at(rest.x(), rest.y()) : kUndefined;
    case SurfaceQuantity::Certainty:
        if (certainty_ == nullptr || !certainty_->isKnown()) {
            return kUndefined;
        }
        return certainty_->isUncertain(rest.x(), rest.y()) ? 0.0 : 1.0;
    case SurfaceQuantity::ForceMap:
        return region_ != nullptr ? region_->at(rest.x(), rest.y()) : kUndefined;
    case SurfaceQuantity::Gap:
        break;
    }
    return kUndefined;
}

ValueRange rangeOf(std::span<const double> values, double leftOut) {
    std::vector<double> finite;
    finite.reserve(values.size());
    std::ranges::copy_if(values, std::back_inserter(finite),
                         [](double value) { return std::isfinite(value); });
    if (finite.empty()) {
        return {};
    }
    if (leftOut <= 0.0) {
        const auto [low, high] = std::ranges::minmax(finite);
        return {low, high};
    }
    const auto rank = static_cast<std::ptrdiff_t>(std::min(leftOut, 0.5) *
                                                  static_cast<double>(finite.size() - 1));
    const auto ranked = [&finite](std::ptrdiff_t index) {
        std::ranges::nth_element(finite, finite.begin() + index);
        return finite[static_cast<std::size_t>(index)];
    };
    const auto last = static_cast<std::ptrdiff_t>(finite.size()) - 1;
    return {ranked(rank), ranked(last - rank)};
}

}  // namespace asperity
