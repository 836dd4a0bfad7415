#include "app/TradeOffCommand.h"

#include "app/LoadedScene.h"
#include "app/OptionChecks.h"
#include "app/ProgressLine.h"
#include "app/RunFolder.h"
#include "app/VirtualDisplay.h"
#include "core/Version.h"
#include "core/fidelity/DeformationStudy.h"
#include "core/fidelity/TradeOffStudy.h"
#include "core/io/CsvWriter.h"
#include "vtkplugins/pictures/Charts.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>

namespace asperity {

namespace {

struct TradeOffOptions {
    std::string scene;
    std::string out;
};

void writeTable(const std::filesystem::path& path, const std::vector<TierResult>& results) {
    CsvWriter csv(path,
                  {std::string("Asperity ") + kVersion +
                       ": cost and error of each fidelity tier; times are of this machine",
                   "errors are against the tier with reference = 1, on the same inputs"},
                  {"tier", "reference", "tick_p50_s", "tick_p99_s", "patch_p50_s",
                   "force_error_rms_n", "force_error_max_n", "contact_radius_error_max_m",
                   "surface_error_rms_m", "surface_error_max_m"});
    for (const TierResult& result : results) {
        csv.add(result.tier.name()).add(result.isReference ? 1.0 : 0.0);
        csv.add(result.tickMedian).add(result.tickP99).add(result.patchMedian);
        csv.add(result.forceErrorRms).add(result.forceErrorMax).add(result.contactRadiusError);
        csv.add(result.surfaceErrorRms).add(result.surfaceErrorMax);
        csv.endRow();
    }
    csv.close();
}

void writeDeformations(const std::filesystem::path& path,
                       const std::vector<DeformationResult>& results) {
    CsvWriter csv(
        path,
        {std::string("Asperity ") + kVersion +
             ": cost and error of each deformation on the paper's materials; times are "
             "of this machine",
         "errors over the patch, relative to the indentation, against the closed form of "
         "the exact sphere on a flat sample and a half-space of finer pixels on the scan; "
         "nan: no reference holds"},
        {"material", "surface", "deformation", "indentation_m", "contact_ratio", "patch_p50_s",
         "cold_patch_p50_s", "error_rms", "error_max", "law_force_n", "own_force_n", "remark"});
    for (const DeformationResult& result : results) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        csv.add(result.material).add(result.surface).add(nameOf(result.tier));
        csv.add(result.indentation).add(result.contactRatio).add(result.time).add(result.coldTime);
        csv.add(result.compared ? result.errorRms : none);
        csv.add(result.compared ? result.errorMax : none);
        csv.add(result.lawForce).add(result.ownForce).add(result.remark);
        csv.endRow();
    }
    csv.close();
}

void printDeformations(const std::vector<DeformationResult>& results) {
    std::printf("\n%-16s %-6s %-15s %6s %9s %9s %9s %10s %10s\n", "material", "on", "deformation",
                "a/R", "patch", "rms err.", "max err.", "law", "own");
    std::printf("%-16s %-6s %-15s %6s %9s %9s %9s %10s %10s\n", "", "", "", "", "[ms]", "[%]",
                "[%]", "force [nN]", "force [nN]");
    for (const DeformationResult& r : results) {
        std::printf("%-16s %-6s %-15s %6.2f %9.2f", r.material.c_str(), r.surface.c_str(),
                    nameOf(r.tier), r.contactRatio, r.time * 1e3);
        if (r.compared) {
            std::printf(" %9.3g %9.3g", r.errorRms * 1e2, r.errorMax * 1e2);
        } else {
            std::printf(" %9s %9s", "-", "-");
        }
        std::printf(" %10.3f %10.3f %s\n", r.lawForce * 1e9, r.ownForce * 1e9, r.remark.c_str());
    }
}

void printTable(const std::vector<TierResult>& results) {
    std::printf("%-42s %9s %9s %9s %12s %12s %12s\n", "tier", "tick p50", "tick p99", "patch",
                "force error", "radius error", "surface err.");
    std::printf("%-42s %9s %9s %9s %12s %12s %12s\n", "", "[us]", "[us]", "[ms]", "rms [nN]",
                "max [nm]", "max [nm]");
    for (const TierResult& r : results) {
        std::printf("%-42s %9.2f %9.2f %9.2f", r.tier.name().c_str(), r.tickMedian * 1e6,
                    r.tickP99 * 1e6, r.patchMedian * 1e3);
        if (r.isReference) {
            std::printf(" %12s %12s %12s\n", "reference", "reference", "reference");
        } else {
            std::printf(" %12.4g %12.4g %12.4g\n", r.forceErrorRms * 1e9,
                        r.contactRadiusError * 1e9, r.surfaceErrorMax * 1e9);
        }
    }
}

/// Dots of error over cost, the reference among them with no error.
class Dots {
public:
    void add(double cost, double error, const std::string& label, bool isReference) {
        curve_.x.push_back(cost);
        curve_.y.push_back(error);
        curve_.pointLabels.push_back(label + (isReference ? " (reference)" : ""));
    }
    [[nodiscard]] Curve curve() const { return curve_; }

private:
    Curve curve_{.label = "", .points = true};
};

/// The deformation does not touch the force, nor the law the cost of a patch: each axis of choice
/// has its own chart, with the other one as in the reference.
void drawFigure(const std::filesystem::path& path, const std::vector<TierResult>& results) {
    const FidelityTier reference = results.back().tier;
    Dots laws;
    Dots deformations;
    for (const TierResult& r : results) {
        if (r.tier.deformation == DeformationTier::FourPoint) {
            laws.add(r.tickMedian, r.forceErrorRms, nameOf(r.tier.law),
                     r.tier.law == reference.law);
        }
        if (r.tier.law == reference.law) {
            deformations.add(r.patchMedian, r.surfaceErrorRms, nameOf(r.tier.deformation),
                             r.isReference);
        }
    }
    const std::array<Chart, 2> charts{Chart{.title = "Contact law: force against time",
                                            .xLabel = "median of a tick",
                                            .yLabel = "rms force error",
                                            .curves = {laws.curve()},
                                            .xUnit = "s",
                                            .yUnit = "N"},
                                      Chart{.title = "Deformation: surface against time",
                                            .xLabel = "median of a patch",
                                            .yLabel = "rms surface error",
                                            .curves = {deformations.curve()},
                                            .xUnit = "s",
                                            .yUnit = "m"}};
    constexpr int kColumns = 2;
    writeCharts(path, charts, kColumns, {.width = 1600, .height = 700});
}

void tradeOff(const TradeOffOptions& options) {
    const VirtualDisplay display;  // before anything is written: the figure needs it at the end
    const LoadedScene loaded = loadSceneOnTerminal(options.scene, {});
    const std::filesystem::path out = options.out;
    makeOutputFolder(out);
    const std::vector<TierResult> results = studyTradeOff(loaded.scene, {});
    writeTable(out / "tradeoff.csv", results);
    drawFigure(out / "tradeoff.png", results);
    printTable(results);
    const std::vector<DeformationResult> deformations = studyDeformation(loaded.scene, {});
    writeDeformations(out / "deformation.csv", deformations);
    printDeformations(deformations);
}

}  // namespace

void addTradeOffCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("tradeoff", "Measured cost and error of every fidelity tier");
    const auto options = std::make_shared<TradeOffOptions>();
    command->add_option("SCENE", options->scene, "scene.toml or height map")->required();
    addOutputFolder(*command, options->out, "folder for the table and the figure");
    command->callback([options] { tradeOff(*options); });
}

}  // namespace asperity
