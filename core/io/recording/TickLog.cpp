#include "core/io/recording/TickLog.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/StoredRow.h"
#include "core/scene/SettingFields.h"

#include <cmath>
#include <limits>
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
    listVector(cell, "device_f", out.deviceForce, "_n");
    cell({"alpha_rad"}, sample.input.measurement.signals.bending);
    cell({"theta_rad"}, sample.input.measurement.signals.torsion);
    cell({"gap_m"}, -out.model.contact.indentation);
    cell({"contact_radius_m"}, out.model.contact.contactRadius);
    cell({"state"}, out.fault == Fault::None ? keyOf(out.region()) : keyOf(out.fault));
    cell({"flags"}, validityText(out.flags));
    cell({"indentation_m"}, out.model.contact.indentation);
    cell({"branch"}, keyOf(branch));
}

/// Lists the columns that a sample adds which is not the same everywhere.
template <class Cell>
void listMaterial(const LocalMaterial& material, const Cell& cell) {
    cell({"youngs_modulus_pa"}, material.youngsModulus);
    cell({"work_of_adhesion_j_m2"}, material.workOfAdhesion);
    cell({"friction_coefficient"}, material.frictionCoefficient);
}

/// The columns of tick_input.csv.
template <class Sample, class Cell>
void listInput(Sample& sample, const Cell& cell) {
    auto& input = sample.input;
    const auto list = [&cell](Column column, auto& value) {
        column.holds = Holds::Told;
        cell(column, value);
    };
    const auto later = [&cell](Column column, auto& value) {
        column.later = true;
        cell(column, value);
    };
    cell({.front = "time_s", .holds = Holds::Finite}, sample.time);
    cell({.front = "time_step_s", .holds = Holds::Positive}, input.timeStep);
    listVector(list, "device_", input.device.position, "_m");
    cell({"buttons"}, input.device.buttons);
    cell({"connected"}, input.device.connected);
    list({"alpha_rad"}, input.measurement.signals.bending);
    list({"theta_rad"}, input.measurement.signals.torsion);
    list({"age_s"}, input.measurement.age);
    later({"starts"}, input.starts);
    later({.front = "device_max_force_n", .holds = Holds::Finite}, input.device.maxForce);
    later({"device_streams"}, input.device.streams);
    later({.front = "device_age_s", .holds = Holds::Told}, input.device.age);
    later({"instrument_connected"}, input.measurement.connected);
    later({"instrument_extrapolated"}, input.measurement.extrapolated);
    later({"instrument_aside"}, input.measurement.aside);
    later({"instrument_ended"}, input.measurement.ended);
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

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

template <class Memory, class Cell>
void listModel(Memory& memory, const Cell& cell) {
    cell({"contact_points"}, memory.model.pointCount);
    for (std::size_t i = 0; i < memory.model.points.size(); ++i) {
        const std::string closest = "contact_point" + std::to_string(i);
        auto& kept = memory.model.points[i];
        cell({closest, "_x_m"}, kept.guess.x);
        cell({closest, "_y_m"}, kept.guess.y);
        cell({closest, "_valid"}, kept.guess.valid);
        cell({closest, "_branch"}, kept.contact.branch);
        cell({closest, "_coordinate"}, kept.contact.coordinate);
        cell({.front = closest, .axis = "_contact_radius_m", .later = true},
             kept.contact.contactRadius);
        cell({closest, "_friction_n"}, kept.friction);
        cell({.front = closest, .axis = "_moved", .later = true}, kept.time.known);
        cell({.front = closest, .axis = "_indentation_m", .later = true}, kept.time.indentation);
        cell({.front = closest, .axis = "_load_m2", .later = true}, kept.time.load);
        cell({.front = closest, .axis = "_relaxing_load_m2", .later = true}, kept.time.relaxing);
    }
    listVector(cell, "deflection_", memory.model.deflection, "_m");
}

template <class Memory, class Cell>
void listSignals(Memory& memory, const Cell& cell) {
    cell({"innovation_normal_defect"}, memory.innovation.normalDefect);
    cell({"innovation_friction_defect"}, memory.innovation.frictionDefect);
    cell({.front = "innovation_normal_variance", .holds = Holds::NotNegative},
         memory.innovation.normalVariance);
    cell({.front = "innovation_friction_variance", .holds = Holds::NotNegative},
         memory.innovation.frictionVariance);
    cell({"innovation_bending_noise"}, memory.innovation.bendingNoise);
    cell({"innovation_torsion_noise"}, memory.innovation.torsionNoise);
    cell({"innovation_age_s"}, memory.innovation.age);
    cell({"innovation_contradicted"}, memory.innovation.contradicted);
    cell({"innovation_friction_wrong"}, memory.innovation.frictionWrong);
    cell({"innovation_noisy"}, memory.innovation.noisy);
    cell({"signals_bending_rad"}, memory.signals.expected.bending);
    cell({"signals_torsion_rad"}, memory.signals.expected.torsion);
    cell({"signals_bending_change_rad"}, memory.signals.change.bending);
    cell({"signals_torsion_change_rad"}, memory.signals.change.torsion);
    cell({"signals_started"}, memory.signals.started);
}

template <class Memory, class Cell>
void listCouplingMemory(Memory& memory, const Cell& cell) {
    cell({"mapping_follows"}, memory.mapping.follows);
    listVector(cell, "proxy_stretch_", memory.proxy.stretch, "_m");
    listVector(cell, "proxy_load_", memory.proxy.load, "_n");
    listVector(cell, "proxy_normal_", memory.proxy.normal, "_1");
    cell({"proxy_friction_n"}, memory.proxy.friction);
    cell({"proxy_stiffness_n_m"}, memory.proxy.gains.stiffness);
    cell({"proxy_coupling_damping_n_s_m"}, memory.proxy.gains.damping);
    cell({"proxy_damping_n_s_m"}, memory.proxy.gains.proxyDamping);
    cell({"proxy_force_gain"}, memory.proxy.forceGain);
}

template <class Memory, class Cell>
void listGuideMemory(Memory& memory, const Cell& cell) {
    cell({"guide"}, memory.guide.fixture.kind);
    listVector(cell, "guide_point_", memory.guide.fixture.point, "_m");
    listVector(cell, "guide_axis_", memory.guide.fixture.axis, "_1");
    cell({"guide_stiffness_n_m"}, memory.guide.fixture.stiffness);
    cell({"guide_damping_n_s_m"}, memory.guide.fixture.damping);
    cell({"guide_force_limit_n"}, memory.guide.fixture.forceLimit);
    cell({.front = "guide_capture_m", .holds = Holds::Endless},
         memory.guide.fixture.captureDistance);
    cell({"guide_position_gain"}, memory.guide.positionGain);
    cell({.front = "guide_share", .holds = Holds::Share}, memory.guide.share);
    listVector(cell, "guide_velocity_", memory.guide.velocity, "_m_s");
}

template <class Memory, class Cell>
void listGovernorMemory(Memory& memory, const Cell& cell) {
    cell({.front = "governor_share", .holds = Holds::Share}, memory.governor.share);
    cell({.front = "governor_edge_share", .holds = Holds::Share}, memory.governor.edgeShare);
    cell({"governor_starts"}, memory.governor.starts);
    listVector(cell, "governor_from_", memory.governor.speed.from, "_m");
    cell({"governor_time_s"}, memory.governor.speed.time);
    cell({"governor_started"}, memory.governor.speed.started);
    cell({"governor_speed_m_s"}, memory.governor.speed.speed);
}

/// The columns of tick_memory.csv.
template <class Memory, class Cell>
void listMemory(Memory& memory, const Cell& cell) {
    const auto later = [&cell](Column column, auto& value) {
        column.later = true;
        cell(column, value);
    };
    listModel(memory, cell);
    listVector(cell, "compensation_", memory.compensation, "_m");
    cell({"control"}, memory.control);
    listVector(cell, "base_", memory.base, "_m");
    listVector(cell, "correction_", memory.correction, "_n");
    listSignals(memory, later);
    listVector(later, "tip_", memory.model.tip, "_m");
    listVector(cell, "device_", memory.mapping.device, "_m");
    listCouplingMemory(memory, later);
    listGuideMemory(memory, later);
    listGovernorMemory(memory, later);
    later({"may_lack_point"}, memory.model.mayLackPoint);
    later({"unsolved_s"}, memory.unsolved);
    later({"asperity_flags"}, memory.asperity.flags);
    later({"asperity_hold_for"}, memory.asperity.holdFor);
    cell({"started"}, memory.started);
    cell({"fault"}, memory.fault);
    cell({"rearms"}, memory.rearms);
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
            const Vector3& point = sample.output.model.closest.point;
            listMaterial(field_->at(point.x(), point.y()), cell);
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

void writeTickMemory(const std::filesystem::path& path, const TickMemory& memory) {
    const auto list = [&memory](const auto& cell) { listMemory(memory, cell); };
    CsvWriter csv(path,
                  {std::string("Asperity ") + kVersion + ": what the first tick starts from",
                   "SI units, as each column's name ends; lab frame"},
                  columnNames(list));
    addCells(csv, list);
    csv.endRow();
    csv.close();
}

TickMemory readTickMemory(const std::filesystem::path& path) {
    const CsvTable table = readCsv(path);
    if (table.rows() != 1) {
        throw InputError(path.string(), "", "expected one row of values");
    }
    TickMemory memory;
    memory.mapping.follows = true;  // there was no clutch
    memory.model.tip.setConstant(kMissing);
    stored::readCells(table, 0, [&memory](const auto& cell) { listMemory(memory, cell); });
    if (memory.model.tip.array().isNaN().any()) {
        memory.model.tip = memory.base + memory.model.deflection;
    }
    return memory;
}

}  // namespace asperity
