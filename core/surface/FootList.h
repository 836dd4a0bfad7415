#pragma once

#include "core/surface/SurfaceFoot.h"

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <span>

namespace asperity {

/// More places than these do not touch a sphere at once on any real scan.
inline constexpr std::size_t kMostFeet = 4;

/// Feet of one query, the nearest first; where there are more than kMostFeet, the nearest of them.
class FootList {
public:
    /// Takes a foot up unless it stands nearer than `sameWithin` [m] to one that does already.
    void add(const SurfaceFoot& foot, double sameWithin) noexcept;

    [[nodiscard]] std::span<const SurfaceFoot> all() const noexcept {
        return {feet_.data(), feet_.size()};
    }

    /// Whether a foot had no room.
    [[nodiscard]] bool hasLeftOut() const noexcept { return hasLeftOut_; }

private:
    boost::container::static_vector<SurfaceFoot, kMostFeet> feet_;
    bool hasLeftOut_ = false;
};

}  // namespace asperity
