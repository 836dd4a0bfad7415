#include "app/reports/ForceCycleTable.h"

#include "core/io/tables/CsvWriter.h"

#include <optional>
#include <string>

namespace asperity {

namespace {

const std::vector<std::string>& columns() {
    static const std::vector<std::string> kColumns{"number",
                                                   "touch_s",
                                                   "off_s",
                                                   "x_m",
                                                   "y_m",
                                                   "snap_in_force_n",
                                                   "snap_in_force_sigma_n",
                                                   "snap_in_force_model_sigma_n",
                                                   "snap_in_distance_m",
                                                   "snap_in_distance_sigma_m",
                                                   "snap_in_distance_model_sigma_m",
                                                   "pull_off_force_n",
                                                   "pull_off_force_sigma_n",
                                                   "pull_off_force_model_sigma_n",
                                                   "adhesion_work_j",
                                                   "hysteresis_j",
                                                   "area_sigma_j",
                                                   "adhesion_work_model_sigma_j",
                                                   "hysteresis_model_sigma_j",
                                                   "contact_stiffness_n_m",
                                                   "contact_stiffness_sigma_n_m",
                                                   "contact_stiffness_model_sigma_n_m",
                                                   "max_force_n",
                                                   "max_force_sigma_n",
                                                   "max_force_model_sigma_n",
                                                   "max_indentation_m",
                                                   "max_indentation_sigma_m",
                                                   "max_indentation_model_sigma_m",
                                                   "material",
                                                   "scan"};
    return kColumns;
}

class Row {
public:
    explicit Row(CsvWriter& csv) : csv_(csv) {}

    void add(double value) { csv_.add(value); }
    void add(const std::string& text) { csv_.add(text); }
    void addIf(bool known, double value) {
        if (known) {
            csv_.add(value);
        } else {
            csv_.add(std::string_view());
        }
    }
    /// The deviation of a reading by model and calibration.
    void addModel(const ForceCycle& entry, const char* key) {
        const std::optional<Budget> budget = budgetNamed(entry.budgets, key);
        addIf(budget && budget->isModelKnown(), budget ? budget->modelAboutValue() : 0.0);
    }
    void add(const std::optional<Reading>& reading) {
        addIf(reading.has_value(), reading ? reading->value : 0.0);
        addIf(reading.has_value(), reading ? reading->sigma : 0.0);
    }

private:
    CsvWriter& csv_;
};

}  // namespace

void writeForceCycles(const std::filesystem::path& file, const std::vector<ForceCycle>& cycles) {
    CsvWriter csv(
        file,
        {"force cycles of the tip, SI units; x and y from the scan's lower left corner; an "
         "empty cell: no such value beyond the noise",
         "sigma: standard deviation by noise; model_sigma: by model and calibration, "
         "empty until the cycle ends, with several contacts at once, "
         "where a part has no state of the model or its law has no such value there; "
         "without terms left out where a model was not judged"},
        columns());
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        const ForceCycle& entry = cycles[i];
        const ContactCycle& cycle = entry.cycle;
        Row row(csv);
        row.add(static_cast<double>(i + 1));
        row.add(cycle.touchTime);
        row.addIf(cycle.complete(), cycle.offTime);
        row.add(cycle.position.x());
        row.add(cycle.position.y());
        row.add(cycle.snapIn);
        row.addModel(entry, "snap_in_force_n");
        row.add(cycleReading("snap_in_distance_m").of(cycle));
        row.addModel(entry, "snap_in_distance_m");
        row.add(cycle.pullOffForce());
        row.addModel(entry, "pull_off_force_n");
        const std::optional<Reading> work = cycle.workOfAdhesion();
        row.addIf(work.has_value(), work ? work->value : 0.0);
        const std::optional<Reading> hysteresis = cycle.closedHysteresis();
        row.addIf(hysteresis.has_value(), hysteresis ? hysteresis->value : 0.0);
        row.add(cycle.areaSigma);
        row.addModel(entry, "adhesion_work_j");
        row.addModel(entry, "hysteresis_j");
        row.add(cycle.stiffness);
        row.addModel(entry, "contact_stiffness_n_m");
        row.add(cycle.maxForce);
        row.addModel(entry, "max_force_n");
        row.add(cycle.maxIndentation);
        row.addModel(entry, "max_indentation_m");
        row.add(entry.material.toStdString());
        row.add(entry.scan.toStdString());
        csv.endRow();
    }
    csv.close();
}

}  // namespace asperity
