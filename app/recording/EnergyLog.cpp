#include "app/recording/EnergyLog.h"

#include "core/Version.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

EnergyLog::EnergyLog(std::filesystem::path path, double timeStep, double delay)
    : path_(std::move(path)), watch_(timeStep, delay) {}

void EnergyLog::take(const TickSample& sample) {
    watch_.take(sample);
    const PassivityObserver* const observer = watch_.observer();
    if (observer == nullptr) {
        return;
    }
    if (!csv_) {
        csv_.emplace(
            GrowingFile(path_),
            std::vector<std::string>{
                std::string("Asperity ") + kVersion + ": energy at the hand; docs/haptics.md",
                "energy_j: that the hand has lost to the coupling beyond what its spring stores, "
                "less what leaked away; below -0.01 the hand is given energy that nobody put in",
                "spring_j: stored by the coupling's spring for the force that acts at the handle"},
            std::vector<std::string>{"time_s", "energy_j", "spring_j"});
    }
    csv_->row(std::array{sample.time, observer->energy(), observer->spring()});
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
