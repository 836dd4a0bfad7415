#include "app/exports/CurveTables.h"

#include "app/reports/RunPictures.h"
#include "core/FormattedText.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"
#include "vtkplugins/pictures/Palette.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace asperity {

namespace {

/// One branch; a sample that is not a number parts its pieces.
Curve branchCurve(const std::vector<CyclePoint>& cycle, CurveBranch branch, const Color& color) {
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    Curve curve{.label = nameOf(branch), .x = {}, .y = {}, .color = color};
    bool parted = true;
    for (const CyclePoint& at : cycle) {
        if (at.branch != branch) {
            parted = true;
            continue;
        }
        if (parted && !curve.x.empty()) {
            curve.x.push_back(kNothing);
            curve.y.push_back(kNothing);
        }
        parted = false;
        curve.x.push_back(at.point.separation);
        curve.y.push_back(at.point.force);
    }
    return curve;
}

}  // namespace

std::vector<Chart> forceCharts(RunPlayback& run, Progress* progress) {
    RunCurves curves;
    run.play(
        0,
        [&curves](const TickSample& sample) {
            curves.take(sample);
            return true;
        },
        progress);
    return curves.charts();
}

std::vector<CyclePoint> cycleAround(RunPlayback& run, std::size_t tick, Progress* progress) {
    CycleDetector detector;
    std::vector<CyclePoint> cycle;
    std::int64_t number = detector.number();
    std::size_t played = 0;
    run.play(
        0,
        [&](const TickSample& sample) {
            detector.take(sample.time, sample.input, sample.output);
            if (detector.number() != number) {
                if (played > tick) {
                    return false;
                }
                number = detector.number();
                cycle.clear();
            }
            ++played;
            if (hasPoint(sample.output)) {
                cycle.push_back({sample.time, detector.branch(), detector.point()});
            }
            return true;
        },
        progress);
    return cycle;
}

Chart cycleChart(const std::vector<CyclePoint>& cycle, const TickSample& moment) {
    Chart chart{.title = "Force–distance curve",
                .xLabel = "tip–sample separation",
                .yLabel = "normal force",
                .curves = {branchCurve(cycle, CurveBranch::Approach, kLightPalette.blue),
                           branchCurve(cycle, CurveBranch::Retract, kLightPalette.orange)},
                .xUnit = "m",
                .yUnit = "N"};
    if (hasPoint(moment.output)) {
        const ForceDistancePoint point = forceDistancePoint(moment.output);
        chart.curves.push_back({.label = formatted("t = %.3f s", moment.time),
                                .x = {point.separation},
                                .y = {point.force},
                                .color = kLightPalette.ink,
                                .points = true});
    }
    return chart;
}

namespace {

std::string madeBy(const char* what) { return std::string("Asperity ") + kVersion + ": " + what; }

/// One row a tick.
class ForcesTable {
public:
    explicit ForcesTable(const std::filesystem::path& path)
        : csv_(path,
               {madeBy("forces, contact and signals of a run"),
                "force on the tip, world frame; indentation < 0: a gap"},
               {"time_s", "force_x_n", "force_y_n", "force_z_n", "model_force_x_n",
                "model_force_y_n", "model_force_z_n", "indentation_m", "contact_radius_m",
                "bending_rad", "torsion_rad"}) {}

    void take(const TickSample& sample) {
        const TickOutput& out = sample.output;
        const Vector3& force = out.estimate.force;
        const Vector3& model = out.model.force;
        const auto& signals = sample.input.measurement.signals;
        csv_.row(std::array{sample.time, force.x(), force.y(), force.z(), model.x(), model.y(),
                            model.z(), out.model.contact.indentation,
                            out.model.contact.contactRadius, signals.bending, signals.torsion});
    }
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

}  // namespace

void writeForcesTable(const std::filesystem::path& path, RunPlayback& run, Progress* progress) {
    ForcesTable table(path);
    run.play(
        0,
        [&table](const TickSample& sample) {
            table.take(sample);
            return true;
        },
        progress);
    table.close();
}

void writeForcesTable(const std::filesystem::path& path, std::span<const TickSample> samples) {
    ForcesTable table(path);
    for (const TickSample& sample : samples) {
        table.take(sample);
    }
    table.close();
}

void writeForceCurvesTable(const std::filesystem::path& path, std::span<const Curve> curves,
                           const std::string& distance) {
    CsvWriter csv(
        path,
        {madeBy("force-distance curves, along the normal"), "force on the tip > 0: repulsive"},
        {"curve", distance, "force_n"});
    for (const Curve& curve : curves) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
                csv.add(curve.label).add(curve.x[i]).add(curve.y[i]).endRow();
            }
        }
    }
    csv.close();
}

void writeCycleTable(const std::filesystem::path& path, const std::vector<CyclePoint>& cycle) {
    CsvWriter csv(path,
                  {madeBy("force-distance curve of one cycle, along the normal"),
                   "force on the tip > 0: repulsive; separation < 0: indented; base: of the "
                   "undeflected tip; sigma: standard deviation of the force by noise"},
                  {"time_s", "branch", "separation_m", "base_distance_m", "force_n", "sigma_n"});
    for (const CyclePoint& at : cycle) {
        csv.add(at.time)
            .add(keyOf(at.branch))
            .add(at.point.separation)
            .add(at.point.baseDistance)
            .add(at.point.force)
            .add(at.point.sigma)
            .endRow();
    }
    csv.close();
}

void writeSectionTable(const std::filesystem::path& path, const ContactSection& section) {
    CsvWriter csv(path,
                  {madeBy("section through the contact, a vertical plane through the tip's axis"),
                   "rest, deformed: the same points of the surface that the tip touches; tip: its "
                   "outline; along: from the tip's axis; x, y, z: world frame"},
                  {"curve", "along_m", "x_m", "y_m", "z_m"});
    const auto add = [&](const char* name, const std::vector<Vector2>& points) {
        for (const Vector2& point : points) {
            const Vector2 position = section.positionAt(point.x());
            csv.add(name).add(point.x()).add(position.x()).add(position.y()).add(point.y());
            csv.endRow();
        }
    };
    add("rest", section.rest);
    add("deformed", section.deformed);
    add("tip", section.tip);
    csv.close();
}

void writePatchTable(const std::filesystem::path& path, const SurfacePatch& patch) {
    CsvWriter csv(path,
                  {madeBy("deformed surface around the contact, world frame"),
                   "a point of the deformed surface is rest plus displacement; normal: of the "
                   "deformed surface, unit; rows of points from the smallest y on"},
                  {"rest_x_m", "rest_y_m", "rest_z_m", "displacement_x_m", "displacement_y_m",
                   "displacement_z_m", "normal_x", "normal_y", "normal_z"});
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        const Vector3& rest = patch.rest[i];
        const Vector3 displacement = patch.points[i] - rest;
        const Vector3& normal = patch.normals[i];
        csv.row(std::array{rest.x(), rest.y(), rest.z(), displacement.x(), displacement.y(),
                           displacement.z(), normal.x(), normal.y(), normal.z()});
    }
    csv.close();
}

}  // namespace asperity
