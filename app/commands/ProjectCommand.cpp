#include "app/commands/CaseFiles.h"
#include "app/commands/Commands.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/loading/SceneLoader.h"
#include "core/Version.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/tables/CaseTable.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/nurbs/NurbsClosestPoint.h"

#include <limits>
#include <memory>
#include <vector>

namespace asperity {

namespace {

constexpr const char* kPointsHelp =
    "The points are a CSV table with the columns x_m,y_m,z_m, in the world frame of the leveled\n"
    "map (x right, y up, origin at the lower left corner). Added are\n"
    "  closest_x_m,closest_y_m,closest_z_m\n"
    "                               closest point on the surface\n"
    "  nx,ny,nz                     the surface's unit normal there, out of the sample\n"
    "  distance_m                   < 0: the point lies below the surface\n"
    "  u,v                          closest point in the surface's own coordinates, 0..1\n"
    "  iterations                   steps of Newton's method\n"
    "  certified                    true: proven that no surface point is nearer\n"
    "  proof                        nearest, or why it is not certified\n"
    "  inside,measured              false: that point lies on the edge of the scan; on a pixel\n"
    "                               without data\n"
    "  curvature_1_per_m,curvature_2_per_m\n"
    "                               principal curvatures there, > 0 for a bump\n"
    "Where the point holds a nan, an infinity or more than 1e50 m there is no closest point: its\n"
    "numbers are nan and the proof is not_converged.";

struct ProjectOptions {
    std::string input;
    CaseFiles files;
    SceneOverrides overrides;
};

struct Projection {
    ClosestPoint closest;
    double u = 0.0;
    double v = 0.0;
    bool measured = true;
};

/// The answer to a point that is none, or so far away that no square of it can be compared.
Projection nowhere() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {.closest = {.point = Vector3::Constant(kNan),
                        .normal = Vector3::Constant(kNan),
                        .distance = kNan,
                        .curvatures = {.largest = kNan, .smallest = kNan},
                        .insideScan = false,
                        .proof = SearchProof::NotConverged},
            .u = kNan,
            .v = kNan,
            .measured = false};
}

Projection onField(const BSplineSurface& surface, const Vector3& point) {
    const ClosestPoint closest = closestPoint(surface, point, {});
    return {.closest = closest,
            .u = closest.point.x() / surface.sizeX(),
            .v = closest.point.y() / surface.sizeY(),
            .measured = surface.isMeasured(closest.point.x(), closest.point.y())};
}

Projection onShape(const NurbsSurface& shape, const Vector3& point) {
    const NurbsClosestPoints points = nearestPoints(shape, point, {});
    Projection result{
        .closest = points.nearest().closest, .u = points.nearest().u, .v = points.nearest().v};
    result.closest.proof = points.proof();
    return result;
}

Projection projectionOn(const Scene& scene, const Vector3& point) {
    if (!(point.array().abs() < kMaxQueryDistance).all()) {  // nan is not less, either
        return nowhere();
    }
    return scene.shape ? onShape(*scene.shape, point) : onField(scene.surface, point);
}

/// A map alone is projected on as it is unless smoothing is asked for; a scene as it says.
SceneOverrides overridesFor(const ProjectOptions& options) {
    SceneOverrides overrides = options.overrides;
    const bool isMap = sceneFromInput(options.input).sample.file == options.input;
    if (isMap && !overrides.smoothingPixels) {
        overrides.smoothingPixels = 0.0;
    }
    return overrides;
}

const char* word(bool value) { return value ? "true" : "false"; }

void write(CsvWriter& csv, const Projection& projection) {
    const ClosestPoint& closest = projection.closest;
    for (const Vector3& vector : {closest.point, closest.normal}) {
        csv.add(vector.x()).add(vector.y()).add(vector.z());
    }
    csv.add(closest.distance)
        .add(projection.u)
        .add(projection.v)
        .add(static_cast<double>(closest.iterations))
        .add(word(closest.certified()))
        .add(keyOf(closest.proof))
        .add(word(closest.insideScan))
        .add(word(projection.measured))
        .add(closest.curvatures.largest)
        .add(closest.curvatures.smallest);
}

std::vector<std::string> commentsFor(const LoadedScene& loaded, const ProjectOptions& options) {
    std::vector<std::string> comments{
        std::string("Asperity ") + kVersion + ": closest points; surface: " + options.input +
            ", points: " + options.files.cases,
        "SI units, as each column's name ends; world frame; 1_per_m: one over meters"};
    comments.insert(comments.end(), loaded.notes.begin(), loaded.notes.end());
    return comments;
}

void project(const ProjectOptions& options) {
    requireWritableTable(options.files.out, {options.files.cases, options.input});
    const CsvTable table = readCases(options.files.cases, {"x_m", "y_m", "z_m"});
    std::vector<Vector3> points;  // all before the first is answered: a table is whole or not
    for (std::size_t row = 0; row < table.rows(); ++row) {
        points.emplace_back(table.number(row, "x_m"), table.number(row, "y_m"),
                            table.number(row, "z_m"));
    }
    const LoadedScene loaded = loadSceneOnTerminal(options.input, overridesFor(options));
    const Scene& scene = loaded.scene;
    const CaseAnswers answers{.comments = commentsFor(loaded, options),
                              .columns = {"closest_x_m", "closest_y_m", "closest_z_m", "nx", "ny",
                                          "nz", "distance_m", "u", "v", "iterations", "certified",
                                          "proof", "inside", "measured", "curvature_1_per_m",
                                          "curvature_2_per_m"},
                              .add = [&](CsvWriter& csv, std::size_t row) {
                                  write(csv, projectionOn(scene, points[row]));
                              }};
    writeTable(options.files.out, [&](std::ostream& out, Progress* progress) {
        writeCases(out, table, answers, progress);
    });
}

}  // namespace

void addProjectCommand(CLI::App& program) {
    const auto options = std::make_shared<ProjectOptions>();
    CLI::App* command =
        program.add_subcommand("project", "Compute the closest point on the fitted surface, with "
                                          "normal, curvatures and whether it is "
                                          "proven, for each point of a table");
    command->footer(kPointsHelp);
    command->add_option("INPUT", options->input, "height map, or scene file")
        ->required()
        ->check(notEmpty());
    command->add_option("--points", options->files.cases, "CSV table, one point a row")
        ->required()
        ->check(notEmpty());
    addTableFile(*command, options->files.out);
    command->add_option("--channel", options->overrides.channel,
                        "channel of the file (default: its first height)");
    addScaleOptions(*command, options->overrides.scale);
    addCropOption(*command, options->overrides.crop);
    addLevelingOptions(*command, options->overrides.leveling, options->overrides.levelPoints,
                       "default: as in the scene, or plane");
    command
        ->add_option(
            "--sigma", options->overrides.smoothingPixels,
            "standard deviation of the Gaussian low-pass [pixel] (default: as in the scene, "
            "or 0)")
        ->check(finiteNumber())
        ->check(CLI::Range(0.0, 100.0));
    command->callback([options] { project(*options); });
}

}  // namespace asperity
