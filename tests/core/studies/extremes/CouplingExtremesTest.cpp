#include "core/Units.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/studies/extremes/TickExtremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <tuple>

namespace asperity {
namespace {

/// Devices at 1 mm : 1 nm and 1 N : 10 nN under a stiff lever.
CouplingGrid gridOf(double tickRate, double delay, double forceGain = 1e8) {
    return {.leverStiffnesses = {14.0},
            .tickRates = {tickRate},
            .delays = {delay},
            .positionGains = {1e-6},
            .forceGains = {forceGain}};
}

std::vector<HoldOutcome> holdsOf(const CouplingGrid& grid) {
    const ExtremesFindings findings = studyExtremes({.coupling = grid});
    EXPECT_EQ(findings.defects, 0);
    EXPECT_EQ(static_cast<long>(findings.holds.size()), grid.holds());
    return findings.holds;
}

long count(const std::vector<HoldOutcome>& holds, bool coupled, HoldVerdict verdict) {
    return std::count_if(holds.begin(), holds.end(), [=](const HoldOutcome& hold) {
        return hold.setting.coupled == coupled && hold.verdict == verdict;
    });
}

TEST(CouplingExtremes, TheCouplingHoldsWhatMakesADirectDeviceOscillate) {
    const std::vector<HoldOutcome> holds = holdsOf(gridOf(1000.0, 5.0_ms));
    EXPECT_EQ(count(holds, true, HoldVerdict::Still), static_cast<long>(holds.size()) / 2);
    EXPECT_GT(count(holds, false, HoldVerdict::Oscillates), 0);
}

TEST(CouplingExtremes, ALoopTooSlowForAnyCouplingIsRefused) {
    const std::vector<HoldOutcome> holds = holdsOf(gridOf(100.0, 5.0_ms));
    EXPECT_EQ(count(holds, true, HoldVerdict::NoCoupling), static_cast<long>(holds.size()) / 2);
    const std::regex sentence(
        "the haptic device holds no coupling stiffer than \\S+ \\S*N/m with a "
        "force that is \\S+ \\S*s old; at least \\S+ \\S*N/m are needed: a "
        "shorter delay or a higher rate");
    EXPECT_TRUE(std::regex_match(holds.front().device.noCoupling, sentence))
        << holds.front().device.noCoupling;
}

TEST(CouplingExtremes, AContactStifferThanTheProxyBearsIsRefusedButForSoftSamples) {
    const CouplingGrid grid = gridOf(1000.0, 1.0_ms, 1e9);
    const CouplingGains gains = designCoupling(
        {.maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = 0.075}, {.delay = 1.0_ms});
    for (const HoldOutcome& hold : holdsOf(grid)) {
        if (hold.setting.coupled) {
            EXPECT_EQ(hold.verdict == HoldVerdict::ScaleTooHigh,
                      hold.device.judgment.contact > stiffestContact(gains, 1.0_ms))
                << hold.setting.material;
            EXPECT_LT(hold.device.judgment.contact, 14.0 * 1e9 * 1e-6 * 1.1);
            EXPECT_LT(hold.device.judgment.felt, gains.stiffness);
            EXPECT_EQ(hold.verdict == HoldVerdict::ScaleTooHigh,
                      hold.setting.material != "silicone rubber");
        }
    }
}

TEST(CouplingExtremes, AnAdhesionStrongerThanTheMotorsIsRefusedWhateverTheStiffness) {
    CouplingGrid grid = gridOf(1000.0, 1.0_ms, 1e10);
    grid.leverStiffnesses = {0.2};
    grid.positionGains = {1e-7};  // the contact is at most 200 N/m
    for (const HoldOutcome& hold : holdsOf(grid)) {
        EXPECT_EQ(hold.device.holds(), hold.setting.workOfAdhesion == 0.0) << hold.setting.material;
        if (hold.setting.coupled) {
            EXPECT_EQ(hold.verdict == HoldVerdict::ScaleTooHigh, !hold.device.holds());
        }
    }
}

TEST(CouplingExtremes, ADeviceThatFeelsThePiconewtonsOfAStiffLeverFeelsTheDetectorsNoise) {
    CouplingGrid grid = gridOf(1000.0, 1.0_ms, 1e10);
    grid.positionGains = {1e-7};
    const std::vector<HoldOutcome> holds = holdsOf(grid);
    EXPECT_GT(count(holds, true, HoldVerdict::Noisy), 0);
}

TEST(CouplingExtremes, AStrideTakesEveryRateWithEveryDelayWithAndWithoutCoupling) {
    CouplingGrid grid = ExtremesGrid::ofAbout(1.1e6).coupling;
    grid.tickRates = {100.0, 250.0};
    std::set<std::tuple<double, double, bool>> met;
    for (const HoldOutcome& hold : holdsOf(grid)) {
        met.emplace(hold.setting.tickRate, hold.setting.delay, hold.setting.coupled);
    }
    EXPECT_GT(grid.stride, 1);
    EXPECT_EQ(met.size(), 2 * grid.tickRates.size() * grid.delays.size());
}

}  // namespace
}  // namespace asperity
