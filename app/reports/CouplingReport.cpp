#include "app/reports/CouplingReport.h"

#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"
#include "core/words/ScaleWords.h"

#include <cstdio>
#include <map>
#include <utility>

namespace asperity {

namespace {

/// Devices with and without a coupling.
struct HoldCounts {
    std::array<long, kValues<HoldVerdict>.size()> coupled{};
    std::array<long, kValues<HoldVerdict>.size()> direct{};

    void count(const HoldOutcome& hold) {
        ++(hold.setting.coupled ? coupled : direct)[static_cast<std::size_t>(hold.verdict)];
    }
};

void printCounts(double rate, double delay, const HoldCounts& counts) {
    std::printf("%8.0f %8.0f", rate, 1e3 * delay);
    for (const HoldVerdict verdict :
         {HoldVerdict::Still, HoldVerdict::Noisy, HoldVerdict::NoCoupling,
          HoldVerdict::ScaleTooHigh, HoldVerdict::Oscillates}) {
        std::printf(" %14ld", counts.coupled.at(static_cast<std::size_t>(verdict)));
    }
    for (const HoldVerdict verdict :
         {HoldVerdict::Still, HoldVerdict::Noisy, HoldVerdict::Oscillates}) {
        std::printf(" %14ld", counts.direct.at(static_cast<std::size_t>(verdict)));
    }
    std::printf("\n");
}

}  // namespace

void writeHolds(const std::filesystem::path& path, const std::vector<HoldOutcome>& holds) {
    CsvWriter csv(path,
                  {std::string("Asperity ") + kVersion +
                       ": simulated devices that hold a tip on a sample; docs/extremes.md",
                   "contact_n_m: maximum stiffness of lever and contact, at the device; felt_n_m: "
                   "the same in series with the coupling; both 0 where no coupling is offered",
                   "scale_holds: result of the stability check; without a coupling it is simulated "
                   "regardless"},
                  {"material", "work_of_adhesion_j_m2", "lever_n_m", "rate_hz", "delay_s",
                   "position_gain", "force_gain", "grip", "coupled", "verdict", "contact_n_m",
                   "felt_n_m", "scale_holds", "swing_m", "refusal"});
    for (const HoldOutcome& hold : holds) {
        const HoldSetting& setting = hold.setting;
        csv.add(setting.material).add(setting.workOfAdhesion).add(setting.leverStiffness);
        csv.add(setting.tickRate).add(setting.delay);
        csv.add(setting.scale.positionGain).add(setting.scale.forceGain);
        csv.add(nameOf(setting.grip)).add(setting.coupled ? 1.0 : 0.0).add(nameOf(hold.verdict));
        const ScaleJudgment& judgment = hold.device.judgment;
        csv.add(judgment.contact).add(judgment.felt).add(hold.device.holds() ? 1.0 : 0.0);
        csv.add(hold.swing).add(refusalOf(hold.device));
        csv.endRow();
    }
    csv.close();
}

void printHolds(const std::vector<HoldOutcome>& holds) {
    std::map<std::pair<double, double>, HoldCounts> counts;
    for (const HoldOutcome& hold : holds) {
        counts[{hold.setting.tickRate, hold.setting.delay}].count(hold);
    }
    std::printf("\n%8s %8s %14s %14s %14s %14s %14s %14s %14s %14s\n", "rate", "delay",
                "coupled:", "", "", "", "", "not coupled:", "", "");
    std::printf("%8s %8s %14s %14s %14s %14s %14s %14s %14s %14s\n", "[Hz]", "[ms]", "still",
                "noisy", "no coupling", "scale too high", "oscillates", "still", "noisy",
                "oscillates");
    for (const auto& [place, count] : counts) {
        printCounts(place.first, place.second, count);
    }
}

}  // namespace asperity
