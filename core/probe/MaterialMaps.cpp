#include "core/probe/MaterialMaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kUniform = 0.1;  // relative difference that laws of uniform bodies may cover

double valueAt(const std::shared_ptr<const PixelField>& map, double x, double y,
               double otherwise) noexcept {
    return map != nullptr ? map->at(x, y) : otherwise;
}

bool differMuch(double a, double b) noexcept {
    return std::abs(a - b) > kUniform * std::max(std::abs(a), std::abs(b));
}

}  // namespace

LocalMaterial MaterialField::at(double x, double y) const noexcept {
    return {.youngsModulus = valueAt(maps_.youngsModulus, x, y, usual_.youngsModulus),
            .workOfAdhesion = valueAt(maps_.workOfAdhesion, x, y, usual_.workOfAdhesion),
            .frictionCoefficient = valueAt(maps_.friction, x, y, usual_.frictionCoefficient)};
}

double MaterialField::reducedModulus(const LocalMaterial& material) const noexcept {
    return asperity::reducedModulus(
        {.youngsModulus = material.youngsModulus, .poissonRatio = poissonRatio_}, tip_);
}

bool MaterialField::variesWithin(double x, double y, double radius) const noexcept {
    const LocalMaterial middle = at(x, y);
    constexpr std::array<std::pair<double, double>, 4> kWays{
        {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}};
    return std::ranges::any_of(kWays, [&](const auto& way) {
        const LocalMaterial rim = at(x + way.first * radius, y + way.second * radius);
        return differMuch(rim.youngsModulus, middle.youngsModulus) ||
               differMuch(rim.workOfAdhesion, middle.workOfAdhesion) ||
               differMuch(rim.frictionCoefficient, middle.frictionCoefficient);
    });
}

}  // namespace asperity
