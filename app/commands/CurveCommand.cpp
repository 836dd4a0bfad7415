#include "app/charts/ChartFile.h"
#include "app/commands/CaseFiles.h"
#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/VirtualDisplay.h"
#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/ForceCurve.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/tables/CsvWriter.h"
#include "core/probe/TimedCurve.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/TipValidity.h"
#include "core/scene/Validity.h"
#include "core/uncertainty/LandmarkBudgets.h"
#include "core/words/BudgetWords.h"
#include "core/words/ModelWords.h"
#include "core/words/SceneWords.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// Options of `asperity curve`; empty or zero: as the scene, or the default scene, says.
struct CurveRequest {
    std::string scene;
    std::vector<std::string> materials;  ///< files, or names of files in the data folder
    std::string law;
    double radius = 0.0;     ///< [m]
    double stiffness = 0.0;  ///< along the normal [N/m]
    double modulus = 0.0;    ///< reduced, of tip and sample [Pa]
};

/// One curve to be made.
struct CurveCase {
    SceneDescription scene;  ///< with the material
    SampleMaterial material;
    ContactModel model;
    double compliance = 0.0;  ///< along the normal [m/N]
    std::string why;          ///< why this law
    TimeTerms time;           ///< of sample and liquid
};

constexpr double kMinStiffness = 1e-6;       // [N/m]
constexpr double kMaxStiffness = 1e12;       // [N/m]
constexpr double kMinReducedModulus = 1.0;   // [Pa]
constexpr double kMaxReducedModulus = 1e13;  // [Pa]

/// A material by the path of its file or by its name in the data folder.
SampleMaterial findMaterial(const std::string& given) {
    if (std::filesystem::exists(given)) {
        return readMaterialFile(given);
    }
    const std::filesystem::path known = dataFolder() / "materials" / (given + ".toml");
    if (std::filesystem::exists(known)) {
        return readMaterialFile(known);
    }
    std::string names;
    for (const auto& file : dataFiles("materials")) {
        names += (names.empty() ? "" : ", ") + file.stem().string();
    }
    throw InputError(given, "", "expected a material file or one of " + names);
}

std::vector<std::string> lawNames() {
    std::vector<std::string> names{"auto"};
    for (const ContactLaw law : kValues<ContactLaw>) {
        names.emplace_back(keyOf(law));
    }
    return names;
}

/// A tip whose own part of any reduced modulus is below rounding.
constexpr Elastic kRigidTip{.youngsModulus = 1e30, .poissonRatio = 0.0};

/// The material with the modulus that gives this reduced one under a rigid tip: of another modulus,
/// another hardness.
SampleMaterial withReducedModulus(SampleMaterial material, double reducedModulus) {
    const double ratio = material.elastic.poissonRatio;
    material.elastic.youngsModulus = reducedModulus * (1.0 - ratio * ratio);
    material.hardness = 0.0;
    return material;
}

CurveCase caseOf(const SceneDescription& scene, ContactLaw law, const std::string& why,
                 double compliance) {
    const SampleMaterial& material = scene.sample.material;
    const ContactPair pair = contactPair(scene, material);
    return {scene,      material, ContactModel(law, pair, contactOptions(scene, material)),
            compliance, why,      timeTerms(scene, material)};
}

/// The case of the scene's material, and another for comparison where the law is not the usual one.
void addCases(const SceneDescription& scene, double compliance, std::vector<CurveCase>& cases) {
    checkScene(scene);
    if (scene.sample.material.maps.any()) {
        throw Error("a curve is of one material, and this sample has maps of several: give a "
                    "--material, or take one pixel by `asperity map --region`");
    }
    const LawChoice choice = lawFor(scene, scene.sample.material);
    cases.push_back(caseOf(scene, choice.law, whyOf(choice), compliance));
    if (!scene.choices.law && choice.law == ContactLaw::SphereSplit) {
        cases.push_back(caseOf(scene, ContactLaw::Split,
                               "for comparison: formally, as for a paraboloid", compliance));
    }
}

CLI::Validator within(double low, double high, const std::string& words) {
    return {[low, high, words](const std::string& text) {
                const double value = std::strtod(text.c_str(), nullptr);
                return value >= low && value <= high ? std::string() : "expected " + words;
            },
            ""};
}

/// The options that make up a request.
void addCurveRequest(CLI::App& command, CurveRequest& request) {
    command.add_option("SCENE", request.scene, "scene.toml (default: the default scene)");
    command
        .add_option("--material", request.materials,
                    "material file or the name of one in data/materials; may be given again")
        ->allow_extra_args(false);
    command.add_option("--law", request.law, "contact law (default: as in the scene, or auto)")
        ->check(CLI::IsMember(lawNames()));
    command.add_option("--radius", request.radius, "tip radius [m]")
        ->check(finiteNumber())
        ->check(within(kMinTipRadius, kMaxTipRadius, "1e-12 to 1 m"));
    command
        .add_option("--reduced-modulus", request.modulus,
                    "reduced modulus E* of tip and sample [Pa], instead of those of the materials")
        ->check(finiteNumber())
        ->check(within(kMinReducedModulus, kMaxReducedModulus, "1 to 1e13 Pa"));
    command
        .add_option("--stiffness", request.stiffness,
                    "stiffness of the lever along the normal [N/m]")
        ->check(finiteNumber())
        ->check(within(kMinStiffness, kMaxStiffness, "1e-6 to 1e12 N/m"));
}

/// One case a material. Where `auto` takes another law than Maugis-Dugdale with its tail, that one
/// follows for comparison. @throw InputError for files that cannot be read, Error for values out of
/// range
std::vector<CurveCase> curveCases(const CurveRequest& request) {
    SceneDescription scene = request.scene.empty() ? defaultScene() : sceneFromInput(request.scene);
    if (!scene.truth.curve.empty()) {
        throw InputError(request.scene, "",
                         "the instrument of this scene plays a recorded curve ([truth] curve), "
                         "which no contact law gives: `explore` plays it");
    }
    scene.tip.radius = request.radius > 0.0 ? request.radius : scene.tip.radius;
    if (request.modulus > 0.0) {
        scene.tip.elastic = kRigidTip;
    }
    if (!request.law.empty()) {
        scene.choices.law = fromKey<ContactLaw>(request.law);  // none: "auto"
    }
    const double compliance = request.stiffness > 0.0 ? 1.0 / request.stiffness
                                                      : Cantilever(scene.probe).compliance()(2, 2);
    std::vector<SampleMaterial> materials;
    for (const std::string& given : request.materials) {
        materials.push_back(findMaterial(given));
    }
    if (materials.empty()) {
        materials.push_back(scene.sample.material);
    }
    std::vector<CurveCase> cases;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        scene.sample.material = request.modulus > 0.0
                                    ? withReducedModulus(materials[i], request.modulus)
                                    : materials[i];
        try {
            addCases(scene, compliance, cases);
        } catch (const Error& error) {
            const std::string file =
                request.materials.empty() ? request.scene : request.materials[i];
            if (file.empty()) {
                throw;  // no file's fault
            }
            throw InputError(file, "", error.what());
        }
    }
    return cases;
}

/// Base positions that a curve is asked to cover [m].
struct BaseRange {
    double from = 0.0;
    double to = 0.0;
};

struct CurveOptions {
    CurveRequest request;
    int points = 500;
    std::optional<BaseRange> base;   ///< none: as the curve needs
    std::optional<double> setpoint;  ///< that ends the approach [N]; none: as the curve needs
    std::optional<double> speed;     ///< of the base [m/s]; none: slow
    std::string out;
    std::string figure;
};

/// A case with what was found.
struct CurveResult {
    CurveCase asked;
    ForceCurve curve;
    LandmarkBudgets budgets;  ///< of a slow curve
    double speed = 0.0;       ///< of the base [m/s]; 0: slow
};

/// "-20nm:5nm", from far to deep; none where it is not that.
std::optional<BaseRange> parseBaseRange(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos) {
        return std::nullopt;
    }
    const std::optional<double> from = parseQuantity(text.substr(0, colon), "m");
    const std::optional<double> to = parseQuantity(text.substr(colon + 1), "m");
    return from && to && *from < *to ? std::optional(BaseRange{*from, *to}) : std::nullopt;
}

void addBaseOption(CLI::App& command, std::optional<BaseRange>& base) {
    command
        .add_option_function<std::string>(
            "--base", [&base](const std::string& text) { base = parseBaseRange(text); },
            "base positions FROM:TO of the curve, > 0 towards the sample, such as -20nm:5nm")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return parseBaseRange(text) ? std::string()
                                            : "expected FROM:TO, lengths such as -20nm:5nm with "
                                              "FROM below TO, not '" +
                                                  text + "'";
            },
            "FROM:TO"));
}

void addSpeedOption(CLI::App& command, std::optional<double>& speed) {
    const auto parsed = [](const std::string& text) {
        const std::optional<double> value = parseQuantity(text, "m/s");
        return value && *value > 0.0 ? value : std::nullopt;
    };
    command
        .add_option_function<std::string>(
            "--speed", [&speed, parsed](const std::string& text) { speed = parsed(text); },
            "speed of the base, such as 5um/s, for a sample that relaxes or a liquid that drags")
        ->check(CLI::Validator(
            [parsed](const std::string& text) {
                return parsed(text) ? std::string()
                                    : "expected a speed such as 5um/s, not '" + text + "'";
            },
            "SPEED"));
}

CLI::Validator pngName() {
    return {[](const std::string& text) {
                return std::filesystem::path(text).extension() == ".png"
                           ? std::string()
                           : "expected the name of a .png file, not '" + text + "'";
            },
            ""};
}

/// "snap-in at -0.494 nm: -1.82 -> -7.92 nN, 1.2e-18 J lost".
std::string jumpText(const char* name, const std::optional<TipJump>& jump) {
    if (!jump) {
        return std::string(name) + ": none, the force is continuous";
    }
    return formatted("%s at base %.6g nm: force %.6g -> %.6g nN, %.4g J lost", name,
                     jump->basePosition * 1e9, jump->before.force * 1e9, jump->after.force * 1e9,
                     jump->after.energyLost);
}

ValidityFlags flagsOf(const CurveResult& result, const ForceCurvePoint& point) {
    const CurveCase& asked = result.asked;
    ValidityFlags flags = contactValidity(asked.model, point.state, asked.material);
    flags.add(attractionValidity(asked.model, point.state, asked.compliance,
                                 flags.has(Validity::ElasticLimit)));
    flags.set(Validity::LargeDeflection,
              asked.scene.probe.isBentTooFar(asked.compliance * point.state.force));
    return flags;
}

/// "large_contact at base 1.2 to 3.4 nm: contact radius above ...".
void addFlagged(const CurveResult& result, std::vector<std::string>& lines) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::array<double, kValidityFlagCount> lowest;
    std::array<double, kValidityFlagCount> highest;
    lowest.fill(kNone);
    highest.fill(-kNone);
    for (const auto* way : {&result.curve.approach, &result.curve.retract}) {
        for (const ForceCurvePoint& point : *way) {
            const ValidityFlags flags = flagsOf(result, point);
            for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
                if (flags.has(kValidityTraits[i].flag)) {
                    lowest[i] = std::min(lowest[i], point.basePosition);
                    highest[i] = std::max(highest[i], point.basePosition);
                }
            }
        }
    }
    for (const Validity flag : kFlagsByEffect) {
        const std::size_t i = indexOf(flag);
        if (lowest[i] <= highest[i]) {
            lines.push_back(formatted("  %s at base %.4g to %.4g nm: %s", kValidityTraits[i].key,
                                      lowest[i] * 1e9, highest[i] * 1e9, kValidityTraits[i].words));
        }
    }
}

/// The strongest pull that the law has: on a stiff lever the tip passes it before it pulls off.
std::string pullText(const std::optional<ForceCurvePoint>& strongest) {
    return strongest ? formatted("strongest pull of the law %.6g nN, at base %.6g nm",
                                 -strongest->state.force * 1e9, strongest->basePosition * 1e9)
                     : "the law never pulls";
}

/// The cone that the law takes into account; nothing where there is none.
std::string coneText(const ContactModel& model) {
    constexpr double kDegree = std::numbers::pi / 180.0;  // [rad]
    const double halfAngle = model.coneHalfAngle();
    return halfAngle > 0.0 ? formatted("cone of %.4g degrees, ", halfAngle / kDegree) : "";
}

/// "adhesion force 17.9 nN ± 2 (tip radius, adhesion)", a line for each number that the curve
/// has.
void addBudgets(const CurveResult& result, std::vector<std::string>& lines) {
    if (!result.asked.scene.uncertainty.enabled || result.speed > 0.0) {
        return;
    }
    for (const LandmarkRow& row : kEnumTable<Landmark>) {
        const Budget& budget = budgetOf(result.budgets, row.value);
        if (std::isfinite(budget.value)) {
            // Under a law without range the tip jumps in when it touches, whatever the inputs.
            lines.push_back("  " + std::string(row.name) + " " + budgetText(budget, row.unit) +
                            (budget.value == 0.0 ? ", by the form of the law" : ""));
        }
    }
}

std::vector<std::string> summary(const CurveResult& result) {
    const CurveCase& asked = result.asked;
    const std::string parameters =
        formatted("%s: R %.4g nm, %sE* %.6g GPa, w %.4g J/m^2, lever %.4g N/m along the normal",
                  asked.material.name.c_str(), asked.model.pair().tipRadius * 1e9,
                  coneText(asked.model).c_str(), asked.model.pair().reducedModulus * 1e-9,
                  asked.model.pair().workOfAdhesion, 1.0 / asked.compliance);
    std::vector<std::string> lines{
        parameters, "  law " + std::string(keyOf(asked.model.law())) + " (" + asked.why + ")",
        "  " + jumpText("snap-in", result.curve.snapIn),
        "  " + jumpText("pull-off", result.curve.pullOff), "  " + pullText(result.curve.strongest)};
    if (hardnessOf(asked.material).source == HardnessSource::Estimated) {
        lines.push_back("  hardness " + hardnessText(asked.material));
    }
    if (result.speed > 0.0) {
        lines.push_back("  the base moves at " + formatSi(result.speed, "m/s"));
    }
    addBudgets(result, lines);
    addFlagged(result, lines);
    return lines;
}

void writeBranch(CsvWriter& csv, const CurveResult& result, CurveBranch branch,
                 const std::vector<ForceCurvePoint>& points) {
    for (const ForceCurvePoint& point : points) {
        const ContactState& state = point.state;
        csv.add(result.asked.material.name).add(keyOf(result.asked.model.law())).add(keyOf(branch));
        csv.add(point.basePosition).add(state.indentation).add(state.force);
        csv.add(state.force * result.asked.compliance).add(state.contactRadius);
        csv.add(state.cohesiveRadius).add(keyOf(state.region()));
        csv.add(validityText(flagsOf(result, point))).endRow();
    }
}

void writeCurves(std::ostream& out, const std::vector<CurveResult>& results, Progress* progress) {
    std::vector<std::string> comments{
        std::string("Asperity ") + kVersion +
            ": approach and retract curves, slow unless they say how fast the base moves",
        "base position > 0 towards the sample, 0 where tip and "
        "sample would first touch; both sides "
        "of a snap-in or pull-off have the same base position"};
    for (const CurveResult& result : results) {
        const std::vector<std::string> lines = summary(result);
        comments.insert(comments.end(), lines.begin(), lines.end());
    }
    const std::vector<std::string> columns{
        "material",          "law",     "way",          "base_position_m",
        "indentation_m",     "force_n", "deflection_m", "contact_radius_m",
        "cohesive_radius_m", "state",   "flags"};
    CsvWriter csv(out, comments, columns);
    double done = 0.0;
    for (const CurveResult& result : results) {
        reportTo(progress, done++ / static_cast<double>(results.size()));
        writeBranch(csv, result, CurveBranch::Approach, result.curve.approach);
        writeBranch(csv, result, CurveBranch::Retract, result.curve.retract);
    }
    reportTo(progress, 1.0);
    csv.close();
}

Curve lineOf(CurveBranch branch, const std::vector<ForceCurvePoint>& way, bool dashed) {
    Curve line{.label = nameOf(branch), .dashed = dashed};
    for (const ForceCurvePoint& point : way) {
        line.x.push_back(point.basePosition);
        line.y.push_back(point.state.force);
    }
    return line;
}

void drawFigure(const std::string& path, const std::vector<CurveResult>& results) {
    std::vector<Chart> charts;
    for (const CurveResult& result : results) {
        std::string name = result.asked.material.name;
        std::ranges::replace(name, '_', ' ');
        charts.push_back({.title = name + ", " + nameOf(result.asked.model.law()),
                          .xLabel = "base position towards the sample",
                          .yLabel = "force on the tip",
                          .curves = {lineOf(CurveBranch::Approach, result.curve.approach, true),
                                     lineOf(CurveBranch::Retract, result.curve.retract, false)},
                          .xUnit = "m",
                          .yUnit = "N"});
    }
    const int columns = std::min<int>(3, static_cast<int>(charts.size()));
    const int rows = (static_cast<int>(charts.size()) + columns - 1) / columns;
    writePng(path, layOut(charts, {.width = 640.0 * columns,
                                   .height = 520.0 * rows,
                                   .columns = static_cast<std::size_t>(columns)}));
}

/// @throw Error where the law does not reach the setpoint
ForceCurvePlan planFor(const CurveCase& asked, const CurveOptions& options) {
    ForceCurvePlan plan = curvePlan(asked.model, asked.compliance);
    plan.points = options.points;
    if (options.base) {
        plan.farthest = options.base->from;
        plan.deepest = options.base->to;
    }
    if (options.setpoint) {
        const std::optional<double> deepest =
            basePositionAt(asked.model, asked.compliance, *options.setpoint);
        if (!deepest) {
            throw Error("law " + std::string(keyOf(asked.model.law())) +
                        " has no state that pushes with " + formatSi(*options.setpoint, "N"));
        }
        plan.deepest = *deepest;
    }
    return plan;
}

/// @throw Error where the forces depend on a speed that is not given
CurveResult curveOf(const CurveCase& asked, const CurveOptions& options) {
    constexpr double kFarFromTheWall = 20.0;  // offsets of the drag: a twentieth of it is left
    ForceCurvePlan plan = planFor(asked, options);
    if (asked.time.drags() && !options.base) {
        plan.farthest = std::min(plan.farthest, -kFarFromTheWall * asked.time.dragOffset);
    }
    if (!asked.time.any()) {
        return {
            asked, forceCurve(asked.model, asked.compliance, plan),
            budgetsOf(asked.scene, asked.model, asked.compliance, options.setpoint.value_or(0.0))};
    }
    if (!options.speed) {
        throw Error("the sample relaxes or a liquid drags the tip, so the curve depends on how "
                    "fast the base moves: give --speed");
    }
    return {asked,
            timedCurve(asked.model, asked.time, asked.compliance,
                       {.way = plan, .speed = *options.speed, .setpoint = options.setpoint}),
            {},
            *options.speed};
}

void curve(const CurveOptions& options) {
    std::vector<std::string> inputs = options.request.materials;
    inputs.push_back(options.request.scene);
    requireWritableTable(options.out, inputs);
    if (!options.figure.empty()) {
        requireWritable(options.figure);
    }
    std::vector<CurveResult> results;
    for (const CurveCase& asked : curveCases(options.request)) {
        results.push_back(curveOf(asked, options));
        if (const std::optional<ShapeDescription>& shape = asked.scene.sample.shape;
            shape && shape->kind != ShapeKind::Plane && results.size() == 1) {
            std::cerr << "note: the curve is that of a flat sample, not of the scene's "
                      << sampleName(asked.scene.sample) << "; asperity map has it\n";
        }
        for (const std::string& line : summary(results.back())) {
            std::cerr << printable(line) << '\n';
        }
    }
    writeTable(options.out,
               [&](std::ostream& out, Progress* progress) { writeCurves(out, results, progress); });
    if (!options.figure.empty()) {
        const OffscreenApplication qt;
        drawFigure(options.figure, results);
    }
}

}  // namespace

void addCurveCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "curve", "Compute approach and retract of a tip on a lever, with snap-in and pull-off");
    const auto options = std::make_shared<CurveOptions>();
    addCurveRequest(*command, options->request);
    command->add_option("--points", options->points, "number of points on each branch")
        ->capture_default_str()
        ->check(CLI::Range(2, 1000000));
    addBaseOption(*command, options->base);
    addSetpointOption(*command, options->setpoint);
    command->get_option("--setpoint")
        ->description("force that ends the approach, such as 5nN; default: the strongest pull")
        ->excludes(command->get_option("--base"));
    addSpeedOption(*command, options->speed);
    addTableFile(*command, options->out);
    command->add_option("--figure", options->figure, "picture to write (.png)")->check(pngName());
    command->callback([options] { curve(*options); });
}

}  // namespace asperity
