#include "core/io/scene/DecouplingFile.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/TextValue.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/tables/CaseTable.h"
#include "core/probe/ForceDecoupling.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// What the lever did in each row, whether it was told in radians or in volts.
struct MeasuredSlopes {
    std::vector<LeverSignals> signals;
    std::vector<LeverSignals> sigma;
};

MeasuredSlopes slopesInRadians(const CsvTable& table) {
    const std::vector<double> bending = table.numbers("alpha_rad");
    const std::vector<double> torsion = table.numbers("theta_rad");
    const std::vector<double> sigmaBending = table.numbers("sigma_alpha_rad");
    const std::vector<double> sigmaTorsion = table.numbers("sigma_theta_rad");
    MeasuredSlopes slopes;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        slopes.signals.push_back({bending[row], torsion[row]});
        slopes.sigma.push_back({sigmaBending[row], sigmaTorsion[row]});
    }
    return slopes;
}

MeasuredSlopes slopesInVolts(const CsvTable& table, const VoltsToSignals& conversion) {
    const std::vector<double> vertical = table.numbers("vertical_v");
    const std::vector<double> lateral = table.numbers("lateral_v");
    const std::vector<double> sigmaVertical = table.numbers("sigma_vertical_v");
    const std::vector<double> sigmaLateral = table.numbers("sigma_lateral_v");
    MeasuredSlopes slopes;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        slopes.signals.push_back(conversion.signals({vertical[row], lateral[row]}));
        // A negative deviation must not become a positive one on the way.
        const bool negative = sigmaVertical[row] < 0.0 || sigmaLateral[row] < 0.0;
        slopes.sigma.push_back(negative
                                   ? LeverSignals{-1.0, -1.0}
                                   : conversion.sigma({sigmaVertical[row], sigmaLateral[row]}));
    }
    return slopes;
}

MeasuredSlopes slopesOf(const CsvTable& table, const Cantilever& lever,
                        const DetectorCalibration& detector) {
    if (!table.has("vertical_v")) {
        return slopesInRadians(table);
    }
    if (table.has("alpha_rad") || table.has("theta_rad")) {
        throw InputError(table.file(), "header",
                         "expected either alpha_rad and theta_rad or vertical_v and lateral_v");
    }
    try {
        return slopesInVolts(table, VoltsToSignals(lever, detector));
    } catch (const InputError&) {
        throw;
    } catch (const Error& error) {
        throw InputError(table.file(), "header", error.what());
    }
}

std::vector<Vector3> vectors(const CsvTable& table, const std::array<const char*, 3>& columns) {
    const std::vector<double> x = table.numbers(columns[0]);
    const std::vector<double> y = table.numbers(columns[1]);
    const std::vector<double> z = table.numbers(columns[2]);
    std::vector<Vector3> all;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        all.emplace_back(x[row], y[row], z[row]);
    }
    return all;
}

std::vector<DecouplingInput> inputsOf(const CsvTable& table, const MeasuredSlopes& slopes) {
    const std::vector<Vector3> normal = vectors(table, {"nx", "ny", "nz"});
    const std::vector<Vector3> velocity = vectors(table, {"vx", "vy", "vz"});
    const std::vector<double> friction = table.numbers("friction_coefficient");
    const std::vector<double> strength = table.numbers("shear_strength_pa");
    const std::vector<double> area = table.numbers("contact_area_m2");
    const std::vector<double> model = table.numbers("normal_force_model_n");
    const std::vector<double> sigma = table.numbers("normal_force_sigma_n");
    const std::vector<double> deviation = table.has("normal_deviation_rad")
                                              ? table.numbers("normal_deviation_rad")
                                              : std::vector<double>(table.rows(), 0.0);
    std::vector<DecouplingInput> inputs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        inputs.push_back({.signals = slopes.signals[row],
                          .sigma = slopes.sigma[row],
                          .normal = normal[row],
                          .normalDeviation = deviation[row],
                          .velocity = velocity[row],
                          .frictionCoefficient = friction[row],
                          .shearStrength = strength[row],
                          .contactArea = area[row],
                          .normalForceModel = model[row],
                          .normalForceSigma = sigma[row]});
    }
    return inputs;
}

void addEstimate(CsvWriter& csv, const ForceEstimate& estimate) {
    const Vector3& f = estimate.force;
    const Matrix3& c = estimate.covariance;
    const bool valid = estimate.kind != DecouplingCase::InvalidInput;
    for (const double value : {f.x(), f.y(), f.z(), c(0, 0), c(1, 1), c(2, 2), c(0, 1), c(0, 2),
                               c(1, 2), estimate.condition}) {
        csv.add(valid ? value : std::numeric_limits<double>::quiet_NaN());
    }
    csv.add(caseText(estimate));
}

std::vector<std::string> commentsFor(const std::string& probe, const std::string& cases,
                                     const Cantilever& lever) {
    return {std::string("Asperity ") + kVersion + " decouple: signals to forces on the tip",
            "probe " + probe + ", stiffness " + exactText(lever.stiffness()) +
                " N/m at the tip; cases " + cases,
            "SI units as each column's name ends; all vectors and the covariance c.._n2 are in the "
            "lab frame; condition: of normal force and friction to signals, without unit",
            "case: regular, near_singular, no_sliding or invalid_input, then what is not plausible "
            "of the force: pushes_along, excess_friction, contradicts_model"};
}

}  // namespace

void writeForceEstimates(const std::filesystem::path& probe, const std::filesystem::path& cases,
                         std::ostream& out, Progress* progress) {
    const ProbeDescription description = readProbe(probe);
    const Cantilever lever(description.lever);
    const CsvTable table = readCsv(cases);
    const std::vector<DecouplingInput> inputs =
        inputsOf(table, slopesOf(table, lever, description.detector));
    writeCases(
        out, table,
        {.comments = commentsFor(probe.string(), cases.string(), lever),
         .columns = {"fx_n", "fy_n", "fz_n", "cxx_n2", "cyy_n2", "czz_n2", "cxy_n2", "cxz_n2",
                     "cyz_n2", "condition", "case"},
         .add = [&](CsvWriter& csv,
                    std::size_t row) { addEstimate(csv, estimateForce(lever, inputs[row])); }},
        progress);
}

}  // namespace asperity
