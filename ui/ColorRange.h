#pragma once

#include "core/deformation/SurfaceField.h"
#include "ui/ColorScale.h"
#include "ui/Steady.h"
#include "ui/SurfaceLook.h"

#include <span>
#include <vector>

namespace asperity {

/// The range of values that the colors of a quantity stand for: as a rule picks it, or pinned.
class ColorRange {
public:
    explicit ColorRange(SurfaceQuantity quantity)
        : smallest_(smallest(quantity)), steady_(smallest_) {}

    /// What a range is made for.
    struct Wish {
        QuantityColors colors;
        bool isSigned = false;  ///< with the diverging map zero has the middle color
        bool isSteady = false;  ///< ends at round numbers that seldom change, of the full range
    };
    /// Fits the range to values, of which some may be no numbers. A pinned range stays as it was
    /// fitted first; one that is to be steady also where all values are zero, as far from a tip.
    /// @return whether range or data are others
    bool fit(std::span<const double> values, const Wish& wish);
    [[nodiscard]] const ValueRange& range() const { return range_; }
    [[nodiscard]] const ValueRange& data() const { return data_; }
    [[nodiscard]] bool hasData() const { return hasData_; }
    /// Adds to a scale what the data are and how the range was chosen.
    void describe(ColorScale& scale, const QuantityColors& colors) const;

private:
    [[nodiscard]] static double smallest(SurfaceQuantity quantity);
    [[nodiscard]] ValueRange wished(std::span<const double> values, const Wish& wish);

    double smallest_;  ///< distance of the ends [unit of the quantity]
    SteadyRange steady_;
    ValueRange range_{0.0, 1.0};
    ValueRange data_;
    bool hasData_ = false;
    bool isFitted_ = false;
};

/// One range for each quantity, so that a pinned one is still there when its quantity is chosen
/// again.
class ColorRanges {
public:
    ColorRanges();
    [[nodiscard]] ColorRange& of(SurfaceQuantity quantity) {
        return ranges_.at(static_cast<std::size_t>(quantity));
    }
    [[nodiscard]] const ColorRange& of(SurfaceQuantity quantity) const {
        return ranges_.at(static_cast<std::size_t>(quantity));
    }
    /// Of another channel ranges begin anew.
    void setChannel(const QString& name);

private:
    std::vector<ColorRange> ranges_;
    QString channel_;
};

}  // namespace asperity
