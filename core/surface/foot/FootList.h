#pragma once

#include "core/surface/foot/SurfaceFoot.h"

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <span>

namespace asperity {

/// More minima of the distance than these are not kept apart: several may stand so near to each
/// other that they are one foot.
inline constexpr std::size_t kMaxMinima = 12;

/// Minima of the distance of one query, the nearest first; where there are more than kMaxMinima,
/// the nearest of them.
class FootList {
public:
    /// Takes a foot up unless it stands nearer than `sameWithin` [m] to one that does already.
    void add(const SurfaceFoot& foot, double sameWithin) noexcept;

    [[nodiscard]] std::span<const SurfaceFoot> all() const noexcept {
        return {feet_.data(), feet_.size()};
    }

    /// Drops all but the nearest ones.
    void keepNearest(std::size_t count) noexcept;
    /// Whether a foot had no room.
    [[nodiscard]] bool hasLeftOut() const noexcept { return hasLeftOut_; }

private:
    boost::container::static_vector<SurfaceFoot, kMaxMinima> feet_;
    bool hasLeftOut_ = false;
};

}  // namespace asperity
