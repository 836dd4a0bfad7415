#include "core/surface/closest/KnownParts.h"

#include "core/Simd.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Loss of a distance by rounding.
constexpr double kSurely = 1.0 - 1e-9;
/// Distance of a plane that is not known.
constexpr double kNowhere = -std::numeric_limits<double>::infinity();

/// Returns whether the query may be moved so far from the one that was asked.
bool isWithin(const Vector3& query, const Vector3& asked, double distance) {
    return distance > 0.0 &&
           (query - asked).squaredNorm() <= kSurely * kSurely * distance * distance;
}

}  // namespace

void KnownParts::Planes::set(std::size_t lane, const Vector3& way, double at) noexcept {
    wayX[lane] = way.x();
    wayY[lane] = way.y();
    wayZ[lane] = way.z();
    offset[lane] = at;
}

void KnownParts::Planes::copy(std::size_t lane, const Planes& from, std::size_t fromLane) noexcept {
    set(lane, {from.wayX[fromLane], from.wayY[fromLane], from.wayZ[fromLane]},
        from.offset[fromLane]);
}

void KnownParts::push(const Known& known) noexcept {
    if (parts_.size() % kGroup == 0) {
        planes_.push_back({});
    }
    planesOf(parts_.size()).set(parts_.size() % kGroup, Vector3::Zero(), kNowhere);
    parts_.push_back(known);
}

void KnownParts::copy(std::size_t to, std::size_t from) noexcept {
    parts_[to] = parts_[from];
    planesOf(to).copy(to % kGroup, planesOf(from), from % kGroup);
}

void KnownParts::shrink(std::size_t size) noexcept {
    while (parts_.size() > size) {
        parts_.pop_back();
    }
    while (planes_.size() > (size + kGroup - 1) / kGroup) {
        planes_.pop_back();
    }
}

bool KnownParts::keepCells(CellSet cells, const Vector3& near) noexcept {
    // Parts that were divided for queries long ago are not put together again, but for this:
    constexpr int kTurns = 8;
    const bool isCrowded = parts_.size() > kMaxParts / 2;
    turn_ = (turn_ + 1) % kTurns;
    const auto isStartedAnew = [&](const CellPart& part) {
        return isCrowded && part.depth > 0 && (part.cell.row + part.cell.column) % kTurns == turn_;
    };
    CellSet unknown = cells;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (cells.holds(parts_[i].part.cell) && !isStartedAnew(parts_[i].part)) {
            unknown.remove(parts_[i].part.cell);
            if (kept != i) {
                copy(kept, i);
            }
            ++kept;
        }
    }
    shrink(kept);
    if (parts_.empty()) {
        origin_ = near;
    }
    bool hasRoom = true;
    unknown.forEach([&](const CellIndex& cell) {
        hasRoom = hasRoom && parts_.size() < kMaxParts;
        if (hasRoom) {
            push({.part = {.cell = cell}});
        }
    });
    return hasRoom;
}

ASPERITY_WITH_AVX2 void KnownParts::findNear(std::span<const Planes> planes, const Vector3& point,
                                             double distance, Lanes& near) noexcept {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Planes& four = planes[i];
        const Double4 nearest = loaded<Double4>(four.offset.data()) -
                                loaded<Double4>(four.wayX.data()) * point.x() -
                                loaded<Double4>(four.wayY.data()) * point.y() -
                                loaded<Double4>(four.wayZ.data()) * point.z();
        near[i] = static_cast<std::uint8_t>(bitsOf(kSurely * nearest < distance));
    }
}

KnownParts::Indices KnownParts::due(const Vector3& query, double distance) const noexcept {
    Lanes near;
    findNear({planes_.data(), planes_.size()}, query - origin_, distance, near);
    Indices due;
    for (std::size_t group = 0; group < planes_.size(); ++group) {
        for (unsigned left = near[group]; left != 0; left &= left - 1) {
            const std::size_t part =
                group * kGroup + static_cast<std::size_t>(std::countr_zero(left));
            if (part < parts_.size() &&
                !isWithin(query, parts_[part].query,
                          std::max(parts_[part].calm, parts_[part].distance - distance))) {
                due.push_back(static_cast<std::uint16_t>(part));
            }
        }
    }
    return due;
}

bool KnownParts::isConvex(std::size_t part, const Vector3& query) const noexcept {
    return isWithin(query, parts_[part].query, parts_[part].convexFor);
}

void KnownParts::note(std::size_t part, const Vector3& query, const PartFacts& facts,
                      int lane) noexcept {
    const auto says = [&](unsigned lanes) {
        return ((lanes & ~facts.far) >> static_cast<unsigned>(lane) & 1U) != 0;
    };
    const Vector3 way(facts.way.x[lane], facts.way.y[lane], facts.way.z[lane]);
    const double perLength = 1.0 / std::max(way.norm(), std::numeric_limits<double>::min());
    planesOf(part).set(part % kGroup, perLength * way,
                       perLength * (facts.alongWay[lane] + way.dot(query - origin_)));
    Known& known = parts_[part];
    known.query = query;
    known.distance = std::sqrt(2.0 * facts.least[lane]);
    known.calm = says(facts.withoutMinimum) ? facts.calm[lane] : 0.0;
    known.convexFor = says(facts.convex) ? facts.convexFor[lane] : 0.0;
}

std::optional<KnownParts::Quarters> KnownParts::split(std::size_t part) noexcept {
    if (parts_[part].part.depth == CellPart::kMaxDepth || parts_.size() + kGroup - 1 > kMaxParts) {
        return std::nullopt;
    }
    const Known whole = parts_[part];
    Quarters quarters{};
    for (std::size_t lane = 0; lane < kGroup; ++lane) {
        Known quarter{.part = whole.part.quarter(static_cast<int>(lane))};
        quarters[lane] = lane == 0 ? part : parts_.size();
        if (lane == 0) {
            parts_[part] = quarter;
            planesOf(part).set(part % kGroup, Vector3::Zero(), kNowhere);
        } else {
            push(quarter);
        }
    }
    return quarters;
}

}  // namespace asperity
