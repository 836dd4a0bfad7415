#include "app/exports/CurveTables.h"

#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"

#include <array>
#include <cmath>
#include <string>

namespace asperity {

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
