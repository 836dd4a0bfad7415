// Time of a single tick in scenes of different kinds, each with the model that it requires:
// closest points, contact law, attraction beside it, decoupling, validity flags. The same approach,
// slide and retract, recorded once, is ticked in turns with the other scenes.

#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "core/Units.h"
#include "core/fidelity/ModelRun.h"
#include "core/fidelity/RequiredTerms.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/Scene.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace asperity {
namespace {

constexpr double kGoal = 6.0;  // of the live loop's tick as well [us]

struct TimedScene {
    std::string name;
    Scene scene;
    std::vector<ModelInputs> runs;
    std::vector<double> medians;    ///< of each round [s]
    std::vector<double> inContact;  ///< the same, of ticks in contact
};

Scene sceneOf(const SceneDescription& description) {
    Scene scene = sceneOnSample(description).scene;
    (void)fitModel(scene);
    return scene;
}

SceneDescription described(const char* name) {
    return readScene(std::string(ASPERITY_SCENES) + "/" + name + ".toml");
}

/// The film under a blunt tip: every asperity near the contact is looked at, and all that lies
/// beside it attracts the tip.
SceneDescription bluntOnFilm(bool attraction) {
    SceneDescription description = described("granular_film");
    description.tip.radius = 2.0_um;
    description.choices.bodyAttraction = attraction;
    return description;
}

TimedScene timedScene(std::string name, const SceneDescription& description) {
    constexpr double kDuration = 2.0;  // [s]
    Scene scene = sceneOf(description);
    std::vector<ModelInputs> runs{
        recordInputs(scene, slidePath(scene, {.duration = kDuration}), kDuration)};
    return {std::move(name), std::move(scene), std::move(runs), {}, {}};
}

/// Times of the ticks in contact, which make all look-ups.
double medianInContact(const ModelRun& run) {
    std::vector<double> times;
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        if (run.states[i].contact.branch == ContactBranch::Bonded) {
            times.push_back(run.times[i]);
        }
    }
    return quantile(std::move(times), 0.5);
}

std::vector<BenchRow> measured(int rounds) {
    std::vector<TimedScene> scenes;
    scenes.push_back(timedScene("flat", described("flat")));
    scenes.push_back(timedScene("terraces", described("silicon")));
    scenes.push_back(timedScene("particles", described("polystyrene")));
    scenes.push_back(timedScene("granular film", described("granular_film")));
    scenes.push_back(
        timedScene("film under a blunt tip, without body attraction", bluntOnFilm(false)));
    scenes.push_back(timedScene("film under a blunt tip, with it", bluntOnFilm(true)));
    for (int round = 0; round < rounds; ++round) {
        for (TimedScene& timed : scenes) {
            const ModelRun run = runModel(timed.scene, timed.runs);
            timed.medians.push_back(quantile(run.times, 0.5));
            timed.inContact.push_back(medianInContact(run));
        }
    }
    std::vector<BenchRow> rows;
    for (const TimedScene& timed : scenes) {
        const auto add = [&](const char* of, const std::vector<double>& medians) {
            rows.push_back({.name = "single tick, " + timed.name + ": " + of,
                            .value = 1e6 * quantile(medians, 0.5),
                            .unit = "us",
                            .goal = kGoal,
                            .kind = GoalKind::AtMost});
        };
        add("median", timed.medians);
        add("median in contact", timed.inContact);
    }
    return rows;
}

int run(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("What a single tick takes");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    constexpr int kRounds = 25;
    constexpr int kQuickRounds = 5;
    giveRows(measured(options.quick ? kQuickRounds : kRounds), options);
    return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::run); }
