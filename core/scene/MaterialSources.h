#pragma once

#include <optional>
#include <string>

namespace asperity {

/// A channel of a file over the area of a scan, or of the part of it that is loaded.
struct MapSource {
    std::string file;     ///< as resolved against the scene file
    std::string channel;  ///< empty: the only one that has the unit
    std::string sha256;   ///< of the file as it was read; empty: it has not been read yet

    bool operator==(const MapSource&) const = default;
};

/// Properties of one of the two materials that a mask distinguishes.
struct MaskedMaterial {
    double youngsModulus = 2e9;   ///< [Pa]
    double workOfAdhesion = 0.0;  ///< of the pair tip-sample [J/m^2]
    double frictionCoefficient = 0.0;

    bool operator==(const MaskedMaterial&) const = default;
};

/// A sample of two materials: between 0 and 1 the mask mixes them.
struct MaterialMask {
    MapSource source;
    MaskedMaterial zero;  ///< where the mask is 0
    MaskedMaterial one;   ///< where it is 1

    bool operator==(const MaterialMask&) const = default;
};

/// Sources of the maps of a material that varies over the sample; none: the quantity is uniform.
struct MaterialSources {
    std::optional<MapSource> youngsModulus;   ///< [Pa]
    std::optional<MapSource> workOfAdhesion;  ///< [J/m^2]
    std::optional<MapSource> friction;        ///< coefficient
    std::optional<MaterialMask> mask;         ///< instead of all of these

    [[nodiscard]] bool any() const noexcept {
        return youngsModulus || workOfAdhesion || friction || mask;
    }
    bool operator==(const MaterialSources&) const = default;
};

/// Calls visit(source) with each source of them. @param sources MaterialSources, const or not
template <class Sources, class Visit>
void forEachSource(Sources& sources, const Visit& visit) {
    for (auto* source : {&sources.youngsModulus, &sources.workOfAdhesion, &sources.friction}) {
        if (*source) {
            visit(**source);
        }
    }
    if (sources.mask) {
        visit(sources.mask->source);
    }
}

}  // namespace asperity
