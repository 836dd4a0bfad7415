#include "app/reports/run/ParameterSource.h"

#include "app/program/DataFolder.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/probe/Cantilever.h"

#include <cmath>

namespace asperity {

namespace {

/// Its name may be another: a scene may say that the material is assumed.
std::string materialFileOf(const SampleMaterial& material) {
    for (const std::filesystem::path& file : dataFiles("materials")) {
        SampleMaterial shipped = readMaterialFile(file);
        shipped.name = material.name;
        if (shipped == material) {
            return file.stem().string();
        }
    }
    return {};
}

/// A scene file keeps a thickness to the last bit, but a stiffness makes one anew.
bool isNear(double value, double other) {
    constexpr double kRounding = 1e-12;
    return std::abs(value - other) <= kRounding * std::abs(other);
}

bool isSameLever(CantileverGeometry lever, const CantileverGeometry& other) {
    if (isNear(lever.thickness, other.thickness)) {
        lever.thickness = other.thickness;
    }
    return lever == other;
}

std::string probeFileOf(const SceneDescription& scene) {
    for (const std::filesystem::path& file : dataFiles("probes")) {
        const ProbeDescription shipped = readProbe(file);
        if (isSameLever(scene.probe, shipped.lever) && scene.detector == shipped.detector) {
            return file.stem().string();
        }
    }
    return {};
}

bool isSame(const SceneValue& value, const SceneValue& other) {
    const auto* const number = std::get_if<double>(&value);
    const auto* const otherNumber = std::get_if<double>(&other);
    return number != nullptr && otherNumber != nullptr ? isNear(*number, *otherNumber)
                                                       : value == other;
}

}  // namespace

ParameterSources::ParameterSources(const SceneDescription& scene)
    : scene_(scene)
    , defaults_(defaultScene())
    , material_(materialFileOf(scene.sample.material))
    , probe_(probeFileOf(scene)) {}

std::string ParameterSources::sourceOf(const SceneField& field) const {
    const std::string key = field.key;
    // No probe file has it.
    const bool isOfEstimator = key == "signal_noise_rad";
    if (field.group == SceneGroup::Material && !material_.empty()) {
        return "library: " + material_;
    }
    if (field.group == SceneGroup::Probe && !probe_.empty() && !isOfEstimator) {
        return "library: " + probe_;
    }
    return isSame(field.get(scene_), field.get(defaults_)) ? "default" : "scene";
}

}  // namespace asperity
