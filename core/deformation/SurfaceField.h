#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/surface/PixelField.h"
#include "core/surface/imaging/TipErosion.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace asperity {

/// Quantity by which a surface can be colored.
enum class SurfaceQuantity : std::uint8_t {
    Height,               ///< of the surface at rest [m]
    Slope,                ///< its angle against the horizontal [rad]
    Gap,                  ///< between deformed sample and tip, along the contact's normal [m]
    Pressure,             ///< on the sample, > 0 compression [Pa]
    Displacement,         ///< into the sample, along the contact's normal [m]
    Residual,             ///< what smoothing and fit left out of the scan: data minus surface [m]
    Certainty,            ///< 1 where the imaging tip has certainly touched the surface, else 0
    YoungsModulus,        ///< of a sample that is not the same everywhere [Pa]
    WorkOfAdhesion,       ///< same [J/m^2]
    FrictionCoefficient,  ///< same
    Channel,              ///< another image of the file, in the file's unit
    ForceMap,             ///< a quantity of a force map, in its region
};

struct SurfaceQuantityRow {
    SurfaceQuantity value;
    const char* key;
    const char* name;
    const char* unit;  ///< SI; "1": a number; empty: the data say
    bool isLive;       ///< it changes with the tip, and is defined around it alone
    bool isSigned;     ///< values on both sides of zero mean different things
};

template <>
inline constexpr auto kEnumTable<SurfaceQuantity> = std::to_array<SurfaceQuantityRow>({
    {SurfaceQuantity::Height, "height", "height", "m", false, false},
    {SurfaceQuantity::Slope, "slope", "slope", "rad", false, false},
    {SurfaceQuantity::Gap, "gap", "gap to the tip", "m", true, false},
    {SurfaceQuantity::Pressure, "pressure", "contact pressure", "Pa", true, true},
    {SurfaceQuantity::Displacement, "displacement", "displacement", "m", true, true},
    {SurfaceQuantity::Residual, "residual", "residual", "m", false, true},
    {SurfaceQuantity::Certainty, "certainty", "certainty", "1", false, false},
    {SurfaceQuantity::YoungsModulus, "youngs_modulus", "Young's modulus", "Pa", false, false},
    {SurfaceQuantity::WorkOfAdhesion, "work_of_adhesion", "work of adhesion", "J/m^2", false,
     false},
    {SurfaceQuantity::FrictionCoefficient, "friction_coefficient", "friction coefficient", "1",
     false, false},
    {SurfaceQuantity::Channel, "channel", "channel", "", false, false},
    {SurfaceQuantity::ForceMap, "force_map", "force map", "", false, false},
});

/// A quantity at each position of a surface at rest. Of quantities that change with the tip this is
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

    /// @param rest   position of the surface [m]
    /// @param normal of the surface there, unit
    /// @return not a number where the quantity is not defined
    [[nodiscard]] double at(const Vector3& rest, const Vector3& normal) const noexcept;
    /// Returns whether a position is in the part of the surface that the field is made of: there a
    /// value that is not a number is missing. @param rest world [m]
    [[nodiscard]] bool covers(const Vector3& rest) const noexcept {
        return region_ == nullptr || region_->covers(rest.x(), rest.y());
    }
    /// Returns whether values are missing in the part that it is made of.
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
