#pragma once

#include "core/Units.h"
#include "core/probe/ForceDecoupling.h"
#include "tests/core/probe/ReferenceLever.h"

#include <string>

namespace asperity::test {

inline constexpr double kSignalNoise = 1e-7;  // of T11 [rad]

inline Cantilever tiltedLever(const std::string& name, double tilt) {
    CantileverGeometry geometry = referenceLever(name);
    geometry.mountTilt = tilt;
    return Cantilever(geometry);
}

inline DecouplingInput inputOfRow(const ReferenceTable& table, std::size_t row) {
    DecouplingInput input;
    input.signals = {table.number(row, "alpha"), table.number(row, "theta")};
    input.sigma = {kSignalNoise, kSignalNoise};
    input.normal = vectorOfRow(table, row, "n");
    input.velocity = vectorOfRow(table, row, "v");
    input.frictionCoefficient = table.number(row, "mu_assumed");
    input.shearStrength = table.number(row, "tau");
    input.contactArea = table.number(row, "A");
    input.normalForceModel = table.number(row, "N_model");
    input.normalForceSigma = table.number(row, "sigma_N");
    return input;
}

/// A tip that slides on a slope, with signals that belong to its force.
struct Situation {
    Cantilever lever;
    DecouplingInput input;
    Vector3 force = Vector3::Zero();
};

inline Situation slidingSituation(const Vector3& normal, const Vector3& velocity) {
    Situation situation{Cantilever(referenceLever("G1_k14")), {}};
    DecouplingInput& input = situation.input;
    input.sigma = {kSignalNoise, kSignalNoise};
    input.normal = normal.normalized();
    input.velocity = velocity;
    input.frictionCoefficient = 0.3;
    input.normalForceModel = 20_nN;
    input.normalForceSigma = 4_nN;
    const Vector3 tangential = velocity - (velocity.dot(input.normal) * input.normal);
    situation.force = 20_nN * (input.normal - (0.3 * tangential.normalized()));
    input.signals = leverSignals(situation.lever, situation.force);
    return situation;
}

}  // namespace asperity::test
