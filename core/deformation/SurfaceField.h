#pragma once

#include "core/Vector.h"
#include "core/deformation/SurfaceQuantity.h"
#include "core/surface/PixelField.h"
#include "core/surface/RegionField.h"
#include "core/surface/imaging/CertaintyMap.h"

#include <memory>
#include <span>
#include <string>

namespace asperity {

/// A quantity at each place of a surface at rest. Of quantities that change with the tip this is
/// the value far from it: no displacement and no pressure; a gap is not defined there.
/// See docs/views.md.
class SurfaceField {
public:
    /// The height.
    SurfaceField() = default;
    /// @param quantity  one that needs neither pixels nor a certainty map
    explicit SurfaceField(SurfaceQuantity quantity) : quantity_(quantity) {}
    /// Certainty. @param certainty outlives the field; known
    explicit SurfaceField(const CertaintyMap& certainty)
        : quantity_(SurfaceQuantity::Certainty), certainty_(&certainty) {}
    /// Residual, a quantity of the material, or another channel. @param name for people, of a
    /// channel
    SurfaceField(SurfaceQuantity quantity, std::shared_ptr<const PixelField> pixels,
                 std::string name = {});
    /// A quantity that a part of the surface has. @param name for people
    SurfaceField(SurfaceQuantity quantity, std::shared_ptr<const RegionField> region,
                 std::string name);

    [[nodiscard]] SurfaceQuantity quantity() const noexcept { return quantity_; }
    [[nodiscard]] bool isLive() const noexcept { return rowOf(quantity_)->isLive; }
    [[nodiscard]] bool isSigned() const noexcept { return rowOf(quantity_)->isSigned; }
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string unit() const;

    /// @param rest   place of the surface [m]
    /// @param normal of the surface there, unit
    /// @return not a number where the quantity is not defined
    [[nodiscard]] double at(const Vector3& rest, const Vector3& normal) const noexcept;
    /// Whether a place is of the part of the surface that the field is made of: there a value that
    /// is not a number is one that is missing. @param rest world [m]
    [[nodiscard]] bool covers(const Vector3& rest) const noexcept {
        return region_ == nullptr || region_->covers(rest.x(), rest.y());
    }
    /// Whether values are missing in the part that it is made of.
    [[nodiscard]] bool hasGaps() const noexcept { return region_ != nullptr && region_->hasGaps(); }

private:
    SurfaceQuantity quantity_ = SurfaceQuantity::Height;
    const CertaintyMap* certainty_ = nullptr;
    std::shared_ptr<const PixelField> pixels_;
    std::shared_ptr<const RegionField> region_;
    std::string name_;
};

/// Lowest and highest of some values.
struct ValueRange {
    double low = 0.0;
    double high = 0.0;
};

/// The range that leaves out this share of the finite values at each end, 0 .. 0.5: of n of them
/// the low end is the one of rank share (n - 1), rounded down, the high end its mirror image.
/// 0 .. 0 where there are none.
[[nodiscard]] ValueRange rangeOf(std::span<const double> values, double leftOut = 0.0);

}  // namespace asperity
