// Lines at a constant force: how well the live z feedback holds the setpoint at several speeds,
// what it overshoots by at walls, and how far its line is from the contact map's, which has no
// delay.

#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/map/MapPlan.h"
#include "core/scene/Scene.h"
#include "tests/support/HeldLine.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace asperity {
namespace {

constexpr double kSpeeds[] = {50e-9, 100e-9, 200e-9};  // [m/s]
constexpr double kFilmGoal = 5.0;                      // rms on the film at 100 nm/s [%]
constexpr double kWallGoal = 3.0;                      // overshoot over that of one tick's delay

SceneDescription described(const char* name) {
    return readScene(std::string(ASPERITY_DATA) + "/scenes/" + name + ".toml");
}

SceneDescription grating() {
    SceneDescription description = described("silicon_oxide");
    description.sample.file = std::string(ASPERITY_DATA) + "/samples/grating.gsf";
    return description;
}

/// What one line showed.
struct LineFigures {
    double rms = 0.0;        ///< error of the force that the bending shows [N]
    double trueRms = 0.0;    ///< of the model's force along z [N]
    double overshoot = 0.0;  ///< force that the bending shows above the setpoint, at most [N]
    double oneTick = 0.0;    ///< stiffness times speed times steepest rise over rate [N]
    /// Largest change of that force in a tick less what the base moved by: where the tip jumps from
    /// one contact to the next it is beyond oneTick, at any speed [N]
    double change = 0.0;
    double fromMap = 0.0;  ///< rms of its height less the contact map's, less their mean [m]
};

/// Steepest rise of the height at which the tip touches, from tick to tick.
double steepestRise(const Scene& scene, const Vector2& start, double length, double step) {
    double steepest = 0.0;
    double before = touchHeight(scene, start.x(), start.y());
    for (double x = step; x < length; x += step) {
        const double height = touchHeight(scene, start.x() + x, start.y());
        steepest = std::max(steepest, std::abs(height - before) / step);
        before = height;
    }
    return steepest;
}

double deviationOf(const std::vector<double>& values) {
    double mean = 0.0;
    for (const double value : values) {
        mean += value / static_cast<double>(values.size());
    }
    double squares = 0.0;
    for (const double value : values) {
        squares += (value - mean) * (value - mean);
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

class LineMeasurement {
public:
    LineMeasurement(const SceneDescription& description, double length)
        : scene_(sceneOnSample(description).scene) {
        const auto columns = std::lround(length / kPitch);
        const Vector2 middle(0.5 * scene_.surface.sizeX(), 0.5 * scene_.surface.sizeY());
        plan_ =
            planMap(scene_, {.mode = MapMode::Contact,
                             .grid = MapGrid{static_cast<int>(columns), 1},
                             .region = MapRegion{middle.x() - 0.5 * length, middle.y() - kPitch,
                                                 middle.x() + 0.5 * length, middle.y() + kPitch},
                             .setpoint = scene_.description.setpoint});
        map_ = rasterLine(MapInstrument(scene_, false), plan_, 0, {});
    }

    [[nodiscard]] LineFigures at(double speed) const {
        const Vector2 start = plan_.position(0, 0);
        const double length = plan_.pitchX() * (plan_.grid.columns - 1);
        const double setpoint = scene_.description.setpoint;
        const test::HeldLine line =
            test::heldLine(scene_, start, {.length = length, .speed = speed}, setpoint);
        LineFigures figures;
        const Vector3 axis = bendingAxis(scene_.belief.cantilever);
        const double compliance = scene_.belief.cantilever.compliance()(2, 2);
        double squares = 0.0;
        double trueSquares = 0.0;
        std::optional<double> before;
        for (const TickSample& sample : line.samples) {
            const double error = axis.dot(sample.output.estimate.force) - setpoint;
            squares += error * error;
            trueSquares += std::pow(sample.output.model.force.z() - setpoint, 2);
            figures.overshoot = std::max(figures.overshoot, error);
            const double atRest = error + sample.output.base.position.z() / compliance;
            figures.change = std::max(figures.change, atRest - before.value_or(atRest));
            before = atRest;
        }
        const auto count = static_cast<double>(line.samples.size());
        figures.rms = std::sqrt(squares / count);
        figures.trueRms = std::sqrt(trueSquares / count);
        const double step = speed * scene_.timeStep();
        figures.oneTick = step * steepestRise(scene_, start, length, step) / compliance;
        figures.fromMap = differenceFromMap(line.samples, step);
        return figures;
    }

private:
    static constexpr double kPitch = 1e-9;  // of the map's pixels [m]

    [[nodiscard]] double differenceFromMap(const std::vector<TickSample>& line, double step) const {
        std::vector<double> differences;
        for (std::size_t i = 0; i < map_.size(); ++i) {
            const auto tick = static_cast<std::size_t>(
                std::lround(static_cast<double>(i) * plan_.pitchX() / step));
            differences.push_back(line.at(tick).output.base.position.z() -
                                  map_[i][MapQuantity::HeightTrace]);
        }
        return deviationOf(differences);
    }

    Scene scene_;
    MapPlan plan_;
    std::vector<MapValues> map_;
};

std::vector<BenchRow> measured(double length) {
    std::vector<BenchRow> rows;
    std::printf("%-14s %7s %8s %10s %11s %11s %11s %12s\n", "line on", "nm/s", "rms [%]",
                "of Fz [%]", "above [nN]", "slope [nN]", "jump [nN]", "to map [pm]");
    const auto measure = [&](const char* name, const SceneDescription& description) {
        const LineMeasurement line(description, length);
        double worst = 0.0;
        for (const double speed : kSpeeds) {
            const LineFigures figures = line.at(speed);
            const double rms = 100.0 * figures.rms / description.setpoint;
            std::printf("%-14s %7.0f %8.2f %10.2f %11.3f %11.3f %11.3f %12.1f\n", name, 1e9 * speed,
                        rms, 100.0 * figures.trueRms / description.setpoint,
                        1e9 * figures.overshoot, 1e9 * figures.oneTick, 1e9 * figures.change,
                        1e12 * figures.fromMap);
            worst = std::max(worst, figures.overshoot / std::max(figures.oneTick, figures.change));
            if (speed == kSpeeds[1] && rows.empty()) {
                rows.push_back({.name = "constant force, granular film at 100 nm/s: rms error",
                                .value = rms,
                                .unit = "%",
                                .goal = kFilmGoal,
                                .kind = GoalKind::AtMost});
            }
        }
        rows.push_back({.name = std::string("constant force, ") + name +
                                ": overshoot over the largest change in a tick, jumps included",
                        .value = worst,
                        .unit = "x",
                        .goal = kWallGoal,
                        .kind = GoalKind::AtMost});
    };
    measure("granular film", described("granular_film"));
    measure("particles", described("particles"));
    measure("grating", grating());
    return rows;
}

int run(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("How well the z feedback holds a force");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    constexpr double kLength = 300e-9;  // [m]
    constexpr double kQuickLength = 100e-9;
    giveRows(measured(options.quick ? kQuickLength : kLength), options);
    return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::run); }
