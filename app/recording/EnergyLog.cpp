#include "app/recording/EnergyLog.h"

#include "core/Version.h"
#include "core/io/recording/ColumnList.h"

#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// The columns of energy_log.csv.
template <class Cell>
void listEnergy(double time, const PassivityObserver& observer, const Cell& cell) {
    cell({"time_s"}, time);
    cell({"energy_j"}, observer.energy());
    cell({"spring_j"}, observer.spring());
}

}  // namespace

EnergyLog::EnergyLog(std::filesystem::path path, double timeStep, double delay)
    : path_(std::move(path)), watch_(timeStep, delay) {}

void EnergyLog::take(const TickSample& sample) {
    watch_.take(sample);
    const PassivityObserver* const observer = watch_.observer();
    if (observer == nullptr) {
        return;
    }
    const auto list = [&](const auto& cell) { listEnergy(sample.time, *observer, cell); };
    if (!csv_) {
        csv_.emplace(
            GrowingFile(path_),
            std::vector<std::string>{
                std::string("Asperity ") + kVersion + ": energy at the device; docs/haptics.md",
                "energy_j: from the device into the coupling, minus that stored in its spring and "
                "that leaked away; below -0.01 the coupling supplies energy of its own",
                "spring_j: stored by the coupling's spring for the force that acts at the handle"},
            columnNames(list));
    }
    addCells(*csv_, list);
    csv_->endRow();
}

void EnergyLog::flush() {
    if (csv_) {
        csv_->flush();
    }
}

void EnergyLog::sync() const {
    if (csv_) {
        csv_->sync();
    }
}

}  // namespace asperity
