#include "core/io/recording/TickLog.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/StoredRow.h"
#include "core/scene/SettingFields.h"

#include <cmath>
#include <string>
#include <utility>

namespace asperity {

namespace {

std::vector<std::string> comments(const char* what) {
    return {std::string("Asperity ") + kVersion + ": " + what,
            "SI units, as each column's name ends; lab frame: x right, y up in the image, z out of "
            "the sample"};
}

Vector3 standardDeviation(const Matrix3& covariance) {
    return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

/// The columns of force_log.csv.
template <class Cell>
void listLog(const TickSample& sample, CurveBranch branch, const Cell& cell) {
    const TickOutput& out = sample.output;
    cell({"time_s"}, sample.time);
    listVector(cell, "base_", out.base.position, "_m");
    listVector(cell, "tip_", out.tip, "_m");
    listVector(cell, "est_f", out.estimate.force, "_n");
    listVector(cell, "est_sigma_f", standardDeviation(out.estimate.covariance), "_n");
    listVector(cell, "model_f", out.model.force, "_n");
    listVector(cell, "hand_f", out.deviceForce, "_n");
    cell({"alpha_rad"}, sample.input.measurement.signals.bending);
    cell({"theta_rad"}, sample.input.measurement.signals.torsion);
    cell({"gap_m"}, -out.model.contact.indentation);
    cell({"contact_radius_m"}, out.model.contact.contactRadius);
    cell({"state"}, out.fault == Fault::None ? keyOf(out.region()) : keyOf(out.fault));
    cell({"flags"}, validityText(out.flags));
    cell({"indentation_m"}, out.model.contact.indentation);
    cell({"branch"}, keyOf(branch));
}

/// Those that a sample adds which is not the same everywhere.
template <class Cell>
void listMaterial(const PlaceMaterial& material, const Cell& cell) {
    cell({"youngs_modulus_pa"}, material.youngsModulus);
    cell({"work_of_adhesion_j_m2"}, material.workOfAdhesion);
    cell({"friction_coefficient"}, material.frictionCoefficient);
}

/// The columns of tick_input.csv.
template <class Sample, class Cell>
void listInput(Sample& sample, const Cell& cell) {
    auto& input = sample.input;
    const auto told = [&cell](Column column, auto& value) {
        column.holds = Holds::Told;
        cell(column, value);
    };
    const auto later = [&cell](Column column, auto& value) {
        column.later = true;
        cell(column, value);
    };
    cell({.front = "time_s", .holds = Holds::Finite}, sample.time);
    cell({.front = "time_step_s", .holds = Holds::Positive}, input.timeStep);
    listVector(told, "hand_", input.device.position, "_m");
    cell({"buttons"}, input.device.buttons);
    cell({"connected"}, input.device.connected);
    told({"alpha_rad"}, input.measurement.signals.bending);
    told({"theta_rad"}, input.measurement.signals.torsion);
    told({"age_s"}, input.measurement.age);
    later({"starts"}, input.starts);
    later({.front = "hand_max_force_n", .holds = Holds::Finite}, input.device.maxForce);
    later({"hand_streams"}, input.device.streams);
    later({.front = "hand_age_s", .holds = Holds::Told}, input.device.age);
    later({"instrument_connected"}, input.measurement.connected);
    listSettings(input.settings, [&cell](const SettingField& field, auto& value) {
        const Holds holds = std::isinf(field.limits.high) ? Holds::Endless : Holds::Stored;
        cell({.front = field.column, .holds = holds, .later = field.later}, value);
    });
}

/// A knob may have what a scene may say of it.
void requireInRange(const Settings& settings, const CsvTable& table, std::size_t row) {
    listSettings(settings, [&](const SettingField& field, const auto& value) {
        if (field.key == nullptr && !field.limits.hold(static_cast<double>(value))) {
            stored::refuse(table, row, std::string(field.column) + " must " + field.limits.words);
        }
    });
    try {
        checkSettings(settings);
    } catch (const Error& error) {
        stored::refuse(table, row, std::string("as in a scene, ") + error.what());
    }
}

}  // namespace

TickTable::TickTable(const std::filesystem::path& path, const char* what,
                     const std::vector<std::string>& columns)
    : csv_(GrowingFile(path), comments(what), columns) {}

ForceLogWriter::ForceLogWriter(const std::filesystem::path& path,
                               std::shared_ptr<const MaterialField> field)
    : TickTable(path, "what the run did, one row a tick", columnNames([&field](const auto& cell) {
                    listLog({}, {}, cell);
                    if (field != nullptr) {
                        listMaterial({}, cell);
                    }
                }))
    , field_(std::move(field)) {}

void ForceLogWriter::take(const TickSample& sample) {
    const CurveBranch branch = branch_.take(sample.input, sample.output);
    addCells(csv_, [&](const auto& cell) {
        listLog(sample, branch, cell);
        if (field_ != nullptr) {
            const Vector3& place = sample.output.model.closest.point;
            listMaterial(field_->at(place.x(), place.y()), cell);
        }
    });
    csv_.endRow();
}

TickInputWriter::TickInputWriter(const std::filesystem::path& path)
    : TickTable(path, "all that the run depended on besides scene.toml, one row a tick",
                columnNames([any = TickSample()](const auto& cell) { listInput(any, cell); })) {}

void TickInputWriter::take(const TickSample& sample) {
    addCells(csv_, [&sample](const auto& cell) { listInput(sample, cell); });
    csv_.endRow();
}

std::vector<TickSample> readTickInputs(const std::filesystem::path& path) {
    return readTickInputs(readCsv(path));
}

std::vector<TickSample> readTickInputs(const CsvTable& table) {
    std::vector<TickSample> samples(table.rows());
    for (std::size_t row = 0; row < samples.size(); ++row) {
        stored::readCells(table, row, [&](const auto& cell) { listInput(samples[row], cell); });
        const Settings& settings = samples[row].input.settings;
        if (row == 0 || settings != samples[row - 1].input.settings) {
            requireInRange(settings, table, row);
        }
    }
    return samples;
}

}  // namespace asperity
