// Chi-square of the estimated force over runs as `asperity explore` makes them, with truth as
// believed and with another friction; how soon the flag comes; how often it comes for nothing.
// asperity_estimate_bench [SECONDS to simulate of each situation of the false alarms]

#include "bench/probe/FalseAlarms.h"
#include "core/fidelity/RequiredTerms.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace asperity {
namespace {

constexpr int kSeeds = 30;
constexpr double kSlideFrom = 3.5;  // of a run of 10 s, see slidePath() [s]
constexpr double kSlideTo = 6.5;    // [s]
constexpr long kTicks = 10001;

struct Mismatch {
    const char* name;
    double friction = 1.0;       ///< factor of mu
    double shearStrength = 0.0;  ///< tau [Pa]
};

constexpr Mismatch kMismatches[] = {{"truth = belief"},
                                    {"mu + 50 %", 1.5},
                                    {"mu - 50 %", 0.5},
                                    {"tau 30 MPa", 1.0, 30e6},
                                    {"mu + 50 %, tau 30 MPa", 1.5, 30e6},
                                    {"mu - 50 %, tau 30 MPa", 0.5, 30e6}};

struct Mean {
    double sum = 0.0;
    long count = 0;

    void add(double value) {
        sum += value;
        ++count;
    }
    [[nodiscard]] double value() const {
        return count > 0 ? sum / static_cast<double>(count) : std::nan("");
    }
};

struct CaseResult {
    Mean before;                 ///< chi-square while sliding, until the first flag
    Mean after;                  ///< from then on
    Mean lateral;                ///< squared error of Fy over its variance, before
    Mean error;                  ///< of Fy, before [N]
    Mean sigma;                  ///< of Fy, before [N]
    Mean errorAfter;             ///< squared, of Fy [N^2]
    Mean flagged;                ///< share of sliding ticks
    long alarms = 0;             ///< flagged ticks outside the slide
    std::vector<double> delays;  ///< from the start of the slide to the flag [s]
};

double chiSquare(const ForceEstimate& estimate, const Vector3& error) {
    return error.dot(estimate.covariance.ldlt().solve(error));
}

void runOnce(const Scene& scene, const PathPlan& plan, std::uint64_t seed, CaseResult& result) {
    InstrumentTruth truth = truthOf(scene);
    truth.seed = seed;
    SimulatedAfm afm(scene.trueSurface(), truth);
    bool seen = false;
    runVirtually(scene, slidePath(scene, plan), afm, kTicks, [&](const TickSample& sample) {
        const TickOutput& out = sample.output;
        const bool flagged = out.flags.has(Validity::EstimateInconsistent);
        if (sample.time <= kSlideFrom || sample.time >= kSlideTo) {
            // On a slope the tip slides, too, while it is drawn off.
            result.alarms += flagged && sample.time <= kSlideFrom ? 1 : 0;
            return;
        }
        if (flagged && !seen) {
            seen = true;
            result.delays.push_back(sample.time - kSlideFrom);
        }
        const Vector3 error = out.estimate.force - afm.trueState().force;
        const double variance = out.estimate.covariance(1, 1);
        (seen ? result.after : result.before).add(chiSquare(out.estimate, error));
        result.flagged.add(flagged ? 1.0 : 0.0);
        if (seen) {
            result.errorAfter.add(error.y() * error.y());
            return;
        }
        result.lateral.add(error.y() * error.y() / variance);
        result.error.add(error.y());
        result.sigma.add(std::sqrt(variance));
    });
}

void print(const char* name, CaseResult result) {
    std::sort(result.delays.begin(), result.delays.end());
    const bool any = !result.delays.empty();
    std::printf("%-22s %6.2f %6.2f %6.2f %6.2f %8.2f %7.2f %4zu/%d %7.3f %7.3f %6.1f %6ld\n", name,
                result.before.value(), result.lateral.value(), 1e9 * result.error.value(),
                1e9 * result.sigma.value(), result.after.value(),
                1e9 * std::sqrt(result.errorAfter.value()), result.delays.size(), kSeeds,
                any ? result.delays[result.delays.size() / 2] : std::nan(""),
                any ? result.delays.back() : std::nan(""), 100.0 * result.flagged.value(),
                result.alarms);
}

Scene sceneOf(const SceneDescription& description) {
    Scene scene = sceneOnSample(description).scene;
    (void)fitModel(scene);
    return scene;
}

void printRuns(const char* title, const PathPlan& plan) {
    std::printf(
        "%s: slide of 3 s, %d seeds; chi2: mean, 3 where the covariance is exact, less where "
        "truth is better than stated\n",
        title, kSeeds);
    std::printf("%-22s %27s %16s\n", "", "before the flag", "after it");
    std::printf("%-22s %6s %6s %6s %6s %8s %7s %7s %7s %7s %6s %6s\n", "", "chi2", "of Fy",
                "Fy off", "sigma", "chi2", "rms Fy", "flagged", "median", "latest", "% of",
                "before");
    std::printf("%-22s %6s %6s %6s %6s %8s %7s %7s %7s %7s %6s %6s\n", "", "", "", "nN", "nN", "",
                "nN", "runs", "s", "s", "ticks", "slide");
    SceneDescription description = readScene(ASPERITY_SCENE);
    for (const Mismatch& mismatch : kMismatches) {
        Friction& friction = description.truth.material.friction;
        friction = {.coefficient =
                        description.sample.material.friction.coefficient * mismatch.friction,
                    .shearStrength = mismatch.shearStrength};
        const Scene scene = sceneOf(description);
        CaseResult result;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            runOnce(scene, plan, static_cast<std::uint64_t>(seed), result);
        }
        print(mismatch.name, std::move(result));
    }
}

int run(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 31'000.0;
    printRuns("explore on polystyrene (18 nN)", {});
    printRuns("the same, lighter (indentation 1 nm)", {.indentation = 1e-9});
    return printFalseAlarms(seconds) ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
    try {
        return asperity::run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return EXIT_FAILURE;
    }
}
