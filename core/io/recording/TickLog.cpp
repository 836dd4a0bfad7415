#include "core/io/recording/TickLog.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/StoredValue.h"
#include "core/scene/SettingFields.h"

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

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
void listLog(const TickSample& sample, const Cell& cell) {
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
}

/// What a cell of tick_input.csv holds.
enum class Holds {
    Stored,    ///< what stands for a value of its type
    Endless,   ///< the same, or infinity
    Finite,    ///< a finite number
    Positive,  ///< a finite number above 0
    Told,      ///< any number: what device and instrument said may be NaN, a fault that replays
};

struct InputColumn : ColumnName {
    Holds holds = Holds::Stored;
    bool later = false;  ///< recordings from before there was such a column read as before
};

/// The columns of tick_input.csv.
template <class Sample, class Cell>
void listInput(Sample& sample, const Cell& cell) {
    auto& input = sample.input;
    const auto told = [&cell](const ColumnName& name, auto& value) {
        cell(InputColumn{name, Holds::Told}, value);
    };
    cell(InputColumn{{"time_s"}, Holds::Finite}, sample.time);
    cell(InputColumn{{"time_step_s"}, Holds::Positive}, input.timeStep);
    listVector(told, "hand_", input.device.position, "_m");
    cell(InputColumn{{"buttons"}}, input.device.buttons);
    cell(InputColumn{{"connected"}}, input.device.connected);
    told({"alpha_rad"}, input.measurement.signals.bending);
    told({"theta_rad"}, input.measurement.signals.torsion);
    told({"age_s"}, input.measurement.age);
    cell(InputColumn{{"starts"}, Holds::Stored, true}, input.starts);
    cell(InputColumn{{"hand_max_force_n"}, Holds::Finite, true}, input.device.maxForce);
    cell(InputColumn{{"hand_streams"}, Holds::Stored, true}, input.device.streams);
    cell(InputColumn{{"hand_age_s"}, Holds::Told, true}, input.device.age);
    cell(InputColumn{{"instrument_connected"}, Holds::Stored, true}, input.measurement.connected);
    listSettings(input.settings, [&cell](const SettingField& field, auto& value) {
        const Holds holds = std::isinf(field.limits.high) ? Holds::Endless : Holds::Stored;
        cell(InputColumn{{field.column}, holds, field.later}, value);
    });
}

/// What a number must be that it is not; null where it is.
template <class Value>
const char* objection(Holds holds, double number) {
    if (holds == Holds::Stored || holds == Holds::Endless) {
        const bool isEnd =
            holds == Holds::Endless && number == std::numeric_limits<double>::infinity();
        return isEnd || stored::standsFor<Value>(number) ? nullptr
                                                         : "a number as Asperity writes it";
    }
    if (holds != Holds::Told && !std::isfinite(number)) {
        return "a finite number";
    }
    return holds == Holds::Positive && !(number > 0.0) ? "positive" : nullptr;
}

[[noreturn]] void refuse(const CsvTable& table, std::size_t row, const std::string& what) {
    throw InputError(table.file(), "line " + std::to_string(table.line(row)), what);
}

/// A knob may have what a scene may say of it.
void requireInRange(const Settings& settings, const CsvTable& table, std::size_t row) {
    listSettings(settings, [&](const SettingField& field, const auto& value) {
        if (field.key == nullptr && !field.limits.hold(static_cast<double>(value))) {
            refuse(table, row, std::string(field.column) + " must " + field.limits.words);
        }
    });
    try {
        checkSettings(settings);
    } catch (const Error& error) {
        refuse(table, row, std::string("as in a scene, ") + error.what());
    }
}

void readInput(const CsvTable& table, std::size_t row, TickSample& sample) {
    listInput(sample, [&](const InputColumn& column, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        const std::string name = column.text();
        if (column.later && !table.has(name)) {
            return;
        }
        const double number = table.number(row, name);
        if (const char* const wanted = objection<Value>(column.holds, number)) {
            refuse(table, row, name + " must be " + wanted);
        }
        value = static_cast<Value>(number);
    });
}

}  // namespace

ForceLogWriter::ForceLogWriter(const std::filesystem::path& path)
    : csv_(GrowingFile(path), comments("what the run did, one row a tick"),
           columnNames([](const auto& cell) { listLog({}, cell); })) {}

void ForceLogWriter::take(const TickSample& sample) {
    addCells(csv_, [&sample](const auto& cell) { listLog(sample, cell); });
    csv_.endRow();
}

TickInputWriter::TickInputWriter(const std::filesystem::path& path)
    : csv_(GrowingFile(path),
           comments("all that the run depended on besides scene.toml, one row a tick"),
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
        readInput(table, row, samples[row]);
        const Settings& settings = samples[row].input.settings;
        if (row == 0 || settings != samples[row - 1].input.settings) {
            requireInRange(settings, table, row);
        }
    }
    return samples;
}

}  // namespace asperity
