#include "core/io/recording/TickLog.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/recording/SceneSettings.h"
#include "core/io/recording/SettingsColumns.h"
#include "core/io/recording/StoredValue.h"
#include "core/io/tables/CsvTable.h"

#include <cmath>
#include <string>

namespace asperity {

namespace {

std::vector<std::string> comments(const char* what) {
    return {std::string("Asperity ") + kVersion + ": " + what,
            "SI units, as each column's name ends; lab frame: x right, y up in the image, z out of "
            "the sample"};
}

CsvWriter& add(CsvWriter& csv, const Vector3& vector) {
    return csv.add(vector.x()).add(vector.y()).add(vector.z());
}

Vector3 standardDeviation(const Matrix3& covariance) {
    return covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
}

/// A cell that must be finite.
double finite(const CsvTable& table, std::size_t row, const std::string& column,
              const std::filesystem::path& path) {
    const double value = table.number(row, column);
    if (!std::isfinite(value)) {
        throw InputError(path.string(), "line " + std::to_string(table.line(row)),
                         column + " must be a finite number");
    }
    return value;
}

/// A cell that must stand for a value of this type.
template <typename Value>
Value valueOf(const CsvTable& table, std::size_t row, const std::string& column,
              const std::filesystem::path& path) {
    const double value = table.number(row, column);
    if (!stored::standsFor<Value>(value)) {
        throw InputError(path.string(), "line " + std::to_string(table.line(row)),
                         column + " must be a number as Asperity writes it");
    }
    return static_cast<Value>(value);
}

/// A knob may have what a scene may say of it.
void requireInRange(const Settings& settings, const std::filesystem::path& path, std::size_t line) {
    try {
        checkSettings(settings);
    } catch (const Error& error) {
        throw InputError(path.string(), "line " + std::to_string(line),
                         std::string("as in a scene, ") + error.what());
    }
}

/// What the device is. Recordings from before there was a governor say nothing of it.
void readDevice(const CsvTable& table, std::size_t row, const std::filesystem::path& path,
                TickInput& input) {
    if (table.has("hand_max_force_n")) {
        input.hand.maxForce = finite(table, row, "hand_max_force_n", path);
        input.hand.streams = valueOf<bool>(table, row, "hand_streams", path);
        input.hand.age = table.number(row, "hand_age_s");
        input.starts = valueOf<std::uint32_t>(table, row, "starts", path);
    }
}

std::vector<std::string> inputColumns() {
    std::vector<std::string> columns{
        "time_s",  "time_step_s",      "hand_x_m",     "hand_y_m",   "hand_z_m",
        "buttons", "connected",        "alpha_rad",    "theta_rad",  "age_s",
        "starts",  "hand_max_force_n", "hand_streams", "hand_age_s", "instrument_connected"};
    const std::vector<std::string> knobs = settingsColumns();
    columns.insert(columns.end(), knobs.begin(), knobs.end());
    return columns;
}

}  // namespace

ForceLogWriter::ForceLogWriter(const std::filesystem::path& path)
    : csv_(GrowingFile(path), comments("what the run did, one row a tick"),
           {"time_s",         "base_x_m",       "base_y_m",         "base_z_m",   "tip_x_m",
            "tip_y_m",        "tip_z_m",        "est_fx_n",         "est_fy_n",   "est_fz_n",
            "est_sigma_fx_n", "est_sigma_fy_n", "est_sigma_fz_n",   "model_fx_n", "model_fy_n",
            "model_fz_n",     "hand_fx_n",      "hand_fy_n",        "hand_fz_n",  "alpha_rad",
            "theta_rad",      "gap_m",          "contact_radius_m", "state",      "flags"}) {}

void ForceLogWriter::take(const TickSample& sample) {
    const TickOutput& out = sample.output;
    csv_.add(sample.time);
    add(csv_, out.base.position);
    add(csv_, out.tip);
    add(csv_, out.estimate.force);
    add(csv_, standardDeviation(out.estimate.covariance));
    add(csv_, out.model.force);
    add(csv_, out.handForce);
    csv_.add(sample.input.measurement.signals.bending)
        .add(sample.input.measurement.signals.torsion)
        .add(-out.model.contact.indentation)
        .add(out.model.contact.contactRadius)
        .add(out.fault == Fault::None ? keyOf(out.region()) : keyOf(out.fault))
        .add(validityText(out.flags))
        .endRow();
}

TickInputWriter::TickInputWriter(const std::filesystem::path& path)
    : csv_(GrowingFile(path),
           comments("all that the run depended on besides scene.toml, one row a tick"),
           inputColumns()) {}

void TickInputWriter::take(const TickSample& sample) {
    const TickInput& input = sample.input;
    csv_.add(sample.time).add(input.timeStep);
    add(csv_, input.hand.position);
    csv_.add(static_cast<double>(input.hand.buttons))
        .add(input.hand.connected ? 1.0 : 0.0)
        .add(input.measurement.signals.bending)
        .add(input.measurement.signals.torsion)
        .add(input.measurement.age)
        .add(static_cast<double>(input.starts))
        .add(input.hand.maxForce)
        .add(input.hand.streams ? 1.0 : 0.0)
        .add(input.hand.age)
        .add(input.measurement.connected ? 1.0 : 0.0);
    addSettings(csv_, input.settings);
    csv_.endRow();
}

std::vector<TickSample> readTickInputs(const std::filesystem::path& path) {
    return readTickInputs(readCsv(path));
}

std::vector<TickSample> readTickInputs(const CsvTable& table) {
    const std::filesystem::path path = table.file();
    std::vector<TickSample> samples(table.rows());
    for (std::size_t row = 0; row < samples.size(); ++row) {
        const auto cell = [&](const char* column) { return finite(table, row, column, path); };
        samples[row].time = cell("time_s");
        TickInput& input = samples[row].input;
        input.timeStep = cell("time_step_s");
        if (!(input.timeStep > 0.0)) {
            throw InputError(path.string(), "line " + std::to_string(table.line(row)),
                             "time_step_s must be positive");
        }
        // What device and instrument said may be NaN: that is a fault, and replays as one.
        const auto told = [&](const char* column) { return table.number(row, column); };
        input.hand.position = {told("hand_x_m"), told("hand_y_m"), told("hand_z_m")};
        input.hand.buttons = valueOf<std::uint32_t>(table, row, "buttons", path);
        input.hand.connected = valueOf<bool>(table, row, "connected", path);
        input.measurement = {.signals = {told("alpha_rad"), told("theta_rad")},
                             .age = told("age_s"),
                             .connected = !table.has("instrument_connected") ||
                                          valueOf<bool>(table, row, "instrument_connected", path)};
        input.settings = readSettings(table, row);
        readDevice(table, row, path, input);
        if (row == 0 || input.settings != samples[row - 1].input.settings) {
            requireInRange(input.settings, path, table.line(row));
        }
    }
    return samples;
}

}  // namespace asperity
