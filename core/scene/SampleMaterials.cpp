#include "core/scene/SampleMaterials.h"

#include "core/Error.h"

#include <utility>

namespace asperity {

namespace {

using Map = std::shared_ptr<const PixelField>;

Map named(bool isNamed, const Map& read, const std::string& what) {
    if (isNamed && read == nullptr) {
        throw Error(what + ": its file has not been read");
    }
    return isNamed ? read : nullptr;
}

constexpr double kHardnessOverModulus = 1.0 / 20.0;
constexpr double kMinEstimatedModulus = 1e9;  ///< [Pa]

}  // namespace

MaterialMaps mapsOf(const SampleMaterial& material, const MaterialMaps& read,
                    const std::string& where) {
    const MaterialSources& sources = material.maps;
    const bool masked = sources.mask.has_value();
    return {.youngsModulus = named(masked || sources.youngsModulus, read.youngsModulus,
                                   where + ": youngs_modulus_map"),
            .workOfAdhesion = named(masked || sources.workOfAdhesion, read.workOfAdhesion,
                                    where + ": work_of_adhesion_map"),
            .friction = named(masked || sources.friction, read.friction, where + ": friction_map")};
}

SampleMaterial withLargest(SampleMaterial material, const MaterialMaps& maps) {
    if (maps.youngsModulus != nullptr) {
        material.elastic.youngsModulus = maps.youngsModulus->highest();
    }
    if (maps.workOfAdhesion != nullptr) {
        material.workOfAdhesion = maps.workOfAdhesion->highest();
    }
    if (maps.friction != nullptr) {
        material.friction.coefficient = maps.friction->highest();
    }
    return material;
}

ContactModel softestContact(const ProbeSystem& system) noexcept {
    const MaterialField* const field = system.field.get();
    if (field == nullptr || field->maps().youngsModulus == nullptr) {
        return system.contact;
    }
    ContactPair pair = system.contact.pair();
    pair.reducedModulus =
        field->reducedModulus({.youngsModulus = field->maps().youngsModulus->lowest(),
                               .workOfAdhesion = pair.workOfAdhesion,
                               .frictionCoefficient = 0.0});
    return system.contact.withPair(pair);
}

std::shared_ptr<const MaterialField> materialField(MaterialMaps maps,
                                                   const SampleMaterial& material,
                                                   const Friction& friction, const Elastic& tip) {
    if (!maps.any()) {
        return nullptr;
    }
    const LocalMaterial usual{.youngsModulus = material.elastic.youngsModulus,
                              .workOfAdhesion = material.workOfAdhesion,
                              .frictionCoefficient = friction.coefficient};
    return std::make_shared<const MaterialField>(std::move(maps), usual,
                                                 material.elastic.poissonRatio, tip);
}

SampleHardness hardnessOf(const SampleMaterial& material) noexcept {
    if (!material.yields) {
        return {.source = HardnessSource::DoesNotYield};
    }
    if (material.hardness > 0.0) {
        return {.source = HardnessSource::Stated, .value = material.hardness};
    }
    const bool isMapped = material.maps.youngsModulus || material.maps.mask;
    const double modulus = material.elastic.youngsModulus;
    return isMapped || modulus < kMinEstimatedModulus
               ? SampleHardness{}
               : SampleHardness{.source = HardnessSource::Estimated,
                                .value = kHardnessOverModulus * modulus};
}

}  // namespace asperity
