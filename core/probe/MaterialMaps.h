#pragma once

#include "core/contact/ContactState.h"
#include "core/surface/PixelField.h"

#include <memory>

namespace asperity {

/// Quantities of a sample that is not the same everywhere, over a scan; null: the same everywhere.
/// Every pixel holds a value.
struct MaterialMaps {
    std::shared_ptr<const PixelField> youngsModulus;   ///< [Pa]
    std::shared_ptr<const PixelField> workOfAdhesion;  ///< of the pair tip-sample [J/m^2]
    std::shared_ptr<const PixelField> friction;        ///< coefficient

    [[nodiscard]] bool any() const noexcept {
        return youngsModulus != nullptr || workOfAdhesion != nullptr || friction != nullptr;
    }
};

/// Material of the sample at one position.
struct LocalMaterial {
    double youngsModulus = 0.0;   ///< [Pa]
    double workOfAdhesion = 0.0;  ///< of the pair tip-sample [J/m^2]
    double frictionCoefficient = 0.0;
};

/// A material with the maps of what is not the same everywhere: the law at a position is that of a
/// uniform sample of the material there. Immutable, safe to read from any thread.
class MaterialField {
public:
    /// @param usual where there is no map
    MaterialField(MaterialMaps maps, const LocalMaterial& usual, double poissonRatio,
                  const Elastic& tip)
        : maps_(std::move(maps)), usual_(usual), poissonRatio_(poissonRatio), tip_(tip) {}

    /// Linear between pixels; a position outside the scan counts as the nearest one inside.
    /// @param x, y world [m]
    [[nodiscard]] LocalMaterial at(double x, double y) const noexcept;
    /// E* of the material with the tip [Pa].
    [[nodiscard]] double reducedModulus(const LocalMaterial& material) const noexcept;
    /// Returns whether modulus, adhesion or friction differ by more than a tenth between the middle
    /// and the rim of a circle around a position [m].
    [[nodiscard]] bool variesWithin(double x, double y, double radius) const noexcept;

    [[nodiscard]] const MaterialMaps& maps() const noexcept { return maps_; }

private:
    MaterialMaps maps_;
    LocalMaterial usual_;
    double poissonRatio_;
    Elastic tip_;
};

}  // namespace asperity
