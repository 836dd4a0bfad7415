#pragma once

#include "core/EnumTable.h"
#include "core/SiFormat.h"
#include "core/deformation/SurfaceField.h"
#include "ui/widgets/Steady.h"
#include "vtkplugins/pictures/ColorMaps.h"

#include <QColor>
#include <QString>
#include <QWidget>

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace asperity {

class ColorTable;

/// Colors of the values, as a color bar shows them.
struct ColorScale {
    QString quantity;            ///< "height"
    QString unit;                ///< of the values; SI units are shown with the fitting prefix
    double low = 0.0;            ///< value of the first color, in `unit`
    double high = 0.0;           ///< value of the last one
    std::vector<QColor> colors;  ///< evenly spread; at least two, or none: nothing to show

    double dataLow = std::numeric_limits<double>::quiet_NaN();   ///< lowest value there is
    double dataHigh = std::numeric_limits<double>::quiet_NaN();  ///< highest value there is
    QString rule;  ///< how the range is chosen, "1–99 %"; empty: all values
    QString note;  ///< why there are no values: "no contact"; empty: there are

    [[nodiscard]] bool clipsLow() const { return dataLow < low; }
    [[nodiscard]] bool clipsHigh() const { return dataHigh > high; }
};

/// The scale of a table's colors.
[[nodiscard]] ColorScale scaleOf(const ColorTable& table, const QString& quantity,
                                 const QString& unit);

/// Scale in which values up to a magnitude are shown: SI units with the fitting prefix, angles in
/// degrees; units that have a prefix already, or are not SI, unchanged; "1" without a unit.
[[nodiscard]] SiScale shownScale(double magnitude, const QString& unit);
/// A value for people, to `digits` digits: "12.3 nm", "45.0 °".
[[nodiscard]] QString shownValue(double value, const QString& unit, int digits = 3);

/// Range of the colors.
enum class RangeRule : std::uint8_t {
    Full,      ///< from the lowest to the highest
    Percent,   ///< without one percent at each end
    Permille,  ///< without one per mille at each end
    Own,       ///< typed numbers
};

template <>
inline constexpr auto kEnumTable<RangeRule> =
    std::to_array<EnumRow<RangeRule>>({{RangeRule::Full, "full", "Full range"},
                                       {RangeRule::Percent, "percent", "1–99 %"},
                                       {RangeRule::Permille, "permille", "0.1–99.9 %"},
                                       {RangeRule::Own, "own", "Own range"}});

/// Colors of one quantity: map, range and its rule.
struct QuantityColors {
    ColorMap map = ColorMap::Standard;
    RangeRule rule = RangeRule::Full;
    double low = 0.0;     ///< of the own range [unit of the quantity]
    double high = 1.0;    ///< same
    bool pinned = false;  ///< the range stays as it is, whatever is shown

    bool operator==(const QuantityColors&) const = default;
};

/// Coloring of a surface, in all views alike; each quantity keeps its own colors.
struct SurfaceLook {
    static constexpr std::size_t kQuantities = kEnumTable<SurfaceQuantity>.size();

    SurfaceQuantity quantity = SurfaceQuantity::Height;
    QString channel;  ///< of the file, for SurfaceQuantity::Channel
    std::array<QuantityColors, kQuantities> colors{};

    /// Values of either sign begin with the diverging map, those of a force map without the few
    /// that stick out.
    SurfaceLook() {
        for (const SurfaceQuantityRow& row : kEnumTable<SurfaceQuantity>) {
            of(row.value).map = row.isSigned ? ColorMap::Diverging : ColorMap::Standard;
        }
        of(SurfaceQuantity::ForceMap).rule = RangeRule::Percent;  // as the sheets of a map have it
    }
    [[nodiscard]] QuantityColors& of(SurfaceQuantity which) {
        return colors.at(static_cast<std::size_t>(which));
    }
    [[nodiscard]] const QuantityColors& of(SurfaceQuantity which) const {
        return colors.at(static_cast<std::size_t>(which));
    }
    /// The range of a quantity is no more pinned or typed.
    void freeRange(SurfaceQuantity which) {
        of(which).pinned = false;
        if (of(which).rule == RangeRule::Own) {
            of(which).rule = RangeRule::Full;
        }
    }
    bool operator==(const SurfaceLook&) const = default;
};

/// The range of values that the colors of a quantity stand for: as a rule picks it, or pinned.
class ColorRange {
public:
    explicit ColorRange(SurfaceQuantity quantity)
        : smallest_(smallest(quantity)), steady_(smallest_) {}

    /// Properties that a range is fitted with.
    struct Wish {
        QuantityColors colors;
        bool isSigned = false;  ///< with the diverging map zero has the middle color
        bool isSteady = false;  ///< ends at round numbers that seldom change, of the full range
    };
    /// Fits the range to values, of which some may be no numbers. A pinned range stays as it was
    /// fitted first; one that is to be steady also where all values are zero, as far from a tip.
    /// @return whether range or data are others
    bool fit(std::span<const double> values, const Wish& wish);
    /// Another scene: the next range is of its values alone, unless it is pinned.
    void forget() {
        steady_ = SteadyRange(smallest_);
        isOther_ = isFitted_;
    }
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
    ValueRange range_{0.0, smallest_};
    ValueRange data_;
    bool hasData_ = false;
    bool isFitted_ = false;
    bool isOther_ = false;  ///< the range is still that of the scene before
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
    /// Resets the ranges when the channel changes.
    void setChannel(const QString& name);
    /// Another scene.
    void forget();

private:
    std::vector<ColorRange> ranges_;
    QString channel_;
};

/// A horizontal bar that shows which colors stand for which values, with name, unit and ticks; how
/// its range was chosen, and by an arrow at an end that values lie beyond it. A right click asks
/// for another coloring (customContextMenuRequested).
class ColorBarWidget : public QWidget {
public:
    explicit ColorBarWidget(QWidget* parent = nullptr);

    void setScale(const ColorScale& scale);

    /// "height [nm]": the text above the bar; empty when there is nothing to show.
    [[nodiscard]] QString heading() const;
    /// "1–99 %", or why there are no values; empty: all values are shown.
    [[nodiscard]] QString remark() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void drawHeading(QPainter& painter, int height) const;
    void drawBar(QPainter& painter, const QRectF& bar) const;
    void drawClips(QPainter& painter, const QRectF& bar) const;
    void drawTicks(QPainter& painter, const QRectF& bar) const;

    ColorScale scale_;
};

}  // namespace asperity
