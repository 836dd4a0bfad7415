#include "app/EnergyLog.h"

#include "core/Version.h"

#include <array>
#include <string>

namespace asperity {

EnergyLog::EnergyLog(const std::filesystem::path& path, double timeStep, double delay)
    : watch_(timeStep, delay)
    , csv_(path,
           {std::string("Asperity ") + kVersion + ": energy at the hand; docs/haptics.md",
            "energy_j: that the hand has lost to the coupling beyond what its spring stores, less "
            "what leaked away; below -0.01 the hand is given energy that nobody put in",
            "spring_j: stored by the coupling's spring for the force that acts at the handle"},
           {"time_s", "energy_j", "spring_j"}) {}

void EnergyLog::take(const TickSample& sample) {
    watch_.take(sample);
    if (const PassivityObserver* const observer = watch_.observer()) {
        csv_.row(std::array{sample.time, observer->energy(), observer->spring()});
        empty_ = false;
    }
}

void EnergyLog::close() {
    if (!empty_) {
        csv_.close();
    }
}

}  // namespace asperity
