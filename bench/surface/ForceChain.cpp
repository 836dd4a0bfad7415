#include "bench/surface/ForceChain.h"

#include "bench/surface/OurQuery.h"
#include "core/Units.h"
#include "core/contact/laws/ContactModel.h"
#include "core/probe/ForceDecoupling.h"
#include "core/surface/closest/ClosestPointSearch.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace asperity {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin, double clock) {
    const std::chrono::duration<double, std::nano> taken = Clock::now() - begin;
    return std::max(taken.count() - clock, 0.0);
}

/// Polystyrene under an oxidized silicon tip.
ContactModel polystyrene() {
    const Elastic sample{.youngsModulus = 2.0_GPa, .poissonRatio = 0.4};
    const Elastic tip{.youngsModulus = 70.0_GPa, .poissonRatio = 0.17};
    return {ContactLaw::Split,
            {.tipRadius = kBenchTipRadius,
             .reducedModulus = reducedModulus(sample, tip),
             .workOfAdhesion = 0.066},
            {.solver = SolverSetting::Table}};
}

Cantilever contactLever() {
    return Cantilever({.youngsModulus = 169.0_GPa,
                       .poissonRatio = 0.27,
                       .length = 450.0_um,
                       .width = 50.0_um,
                       .thickness = 2.0_um,
                       .tipHeight = 15.0_um,
                       .mountTilt = 0.21});
}

/// One instant after another.
class Chain {
public:
    explicit Chain(const BSplineSurface& surface)
        : surface_(surface), model_(polystyrene()), lever_(contactLever()) {
        input_.velocity = Vector3(1e-6, 0.0, 0.0);
        input_.frictionCoefficient = 0.3;
        input_.sigma = {.bending = 1e-7, .torsion = 1e-7};
        input_.normalForceSigma = 0.1_nN;
    }

    void start() {
        guess_ = {};
        tracker_ = {};
        memory_ = {};
    }

    /// @return the force that was told, which the compiler must believe to be used [N]
    double next(const Vector3& center) {
        const ClosestPoint closest = closestPoint(surface_, center, guess_, tracker_);
        guess_ = closest.guess();
        const ContactState state =
            model_.equilibrium(kBenchTipRadius - closest.distance, 0.0, memory_);
        memory_ = state.memory();
        input_.signals = leverSignals(lever_, state.force * closest.normal);
        input_.normal = closest.normal;
        input_.normalForceModel = state.force;
        return estimateForce(lever_, input_).force.z();
    }

private:
    const BSplineSurface& surface_;
    ContactModel model_;
    Cantilever lever_;
    DecouplingInput input_;
    SearchGuess guess_;
    ClosestPointTracker tracker_;
    ContactMemory memory_;
};

void shorten(double& best, double time) { best = std::min(best, time); }

}  // namespace

ChainResult timeChain(const BSplineSurface& surface, std::span<const Vector3> tips, int passes) {
    const double clock = clockCost();
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::vector<double> whole(tips.size(), kNone);
    std::vector<double> pointOnly(tips.size(), kNone);
    Chain chain(surface);
    const auto closest = ourMethod(surface, SearchEffort::Certified);
    volatile double used = 0.0;
    for (int pass = 0; pass < passes; ++pass) {
        chain.start();
        closest->start(tips.front().head<2>());
        for (std::size_t i = 0; i < tips.size(); ++i) {
            auto begin = Clock::now();
            used = chain.next(tips[i]);
            shorten(whole[i], since(begin, clock));
            begin = Clock::now();
            used = closest->next(tips[i]).position.x();
            shorten(pointOnly[i], since(begin, clock));
        }
    }
    static_cast<void>(used);
    return {.time = summaryOf(whole), .closest = summaryOf(pointOnly)};
}

}  // namespace asperity
