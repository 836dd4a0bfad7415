#include "app/commands/Commands.h"
#include "app/commands/FitOptions.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/curves/FitBatch.h"
#include "app/curves/FitFiles.h"
#include "app/curves/FitScene.h"
#include "app/program/EndSignals.h"
#include "app/runs/OutputFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/ShareOut.h"
#include "core/identify/SpringConstant.h"
#include "core/io/FileBytes.h"
#include "core/io/curves/ForceCurveFile.h"
#include "core/io/curves/ThermalSpectrumFile.h"
#include "core/io/curves/TipAreaFunction.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/TomlFile.h"
#include "core/probe/CantileverModes.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// Files of one curve. A refused one leaves no tables.
FolderContent fitFolder() {
    return {.marks = {"fit.json"},
            .own = {"curve.csv", "simulated.csv", "fit.png", "material.toml", "probe.toml",
                    "scene.toml"},
            .guarded = {"fit.json"}};
}

FolderContent batchFolder() {
    return {.marks = {"fits.csv"}, .own = {"fits.json"}, .guarded = {"fits.csv"}};
}

FittedCurve fitted(const std::string& path, const FitRequest& request) {
    const FileBytes bytes(path);
    const ForceCurveFile file(bytes, request.read.read);
    const std::size_t index = request.read.index.value_or(0);
    CurveContents contents = file.contents(index);
    FittedCurve curve{.file = path, .index = index, .sha256 = sha256Of(bytes)};
    curve.heightChannel = std::move(contents.heightChannel);
    curve.notes = file.notes();
    curve.notes.insert(curve.notes.end(), contents.notes.begin(), contents.notes.end());
    curve.found = identifyCurve(contents.curve, request.fit);
    if (request.fit.compares && curve.found.verdict != FitVerdict::Refused) {
        curve.comparison = compareCurve(contents.curve, request.fit);
    }
    return curve;
}

void printSummary(const FittedCurve& curve) {
    for (const std::string& line : fitSummary(curve)) {
        std::cout << printable(line) << '\n';
    }
}

/// @throw Error where the curve was refused, after its files are written
void fitOne(const FitRequest& request) {
    const FittedCurve curve = fitted(request.curves.front(), request);
    const bool refused = curve.found.verdict == FitVerdict::Refused;
    const std::string noScene = refusalOfScene(curve);
    OutputFolder out(request.out, fitFolder(), request.force);
    out.collect([&](const std::filesystem::path& folder) {
        writeFitJson(folder / "fit.json", fitJson(curve));
        if (!refused) {
            const OffscreenApplication qt;  // the figure needs its fonts
            writeMeasuredCurve(folder / "curve.csv", curve);
            writeSimulatedCurve(folder / "simulated.csv", curve);
            writeFitFigure(folder / "fit.png", curve);
        }
        if (noScene.empty()) {
            writeFitScene(folder, curve);
        }
    });
    out.commit();
    if (refused) {
        throw Error(curve.file + " is refused: " + curve.found.reasons.front());
    }
    printSummary(curve);
    std::cout << "  "
              << (noScene.empty() ? "scene.toml describes sample, tip and lever as found"
                                  : "no scene.toml: " + printable(noScene))
              << '\n';
}

/// Returns the result for one file; one that cannot be read ends nothing.
FittedCurve attempted(const std::string& file, const FitRequest& request) {
    try {
        return fitted(file, request);
    } catch (const FileError& error) {
        return {.file = file, .sha256 = {}, .error = error.what()};
    }
}

/// @throw Error where no curve could be fitted, after the table is written
void fitMany(const FitRequest& request) {
    const CancelOnSignal cancel;
    std::vector<FittedCurve> curves(request.curves.size());
    ProgressLine line("fitting");
    shareOut(static_cast<int>(curves.size()), &line, [&](int index, const CancelCheck&) {
        const auto i = static_cast<std::size_t>(index);
        curves[i] = attempted(request.curves[i], request);
    });
    OutputFolder out(request.out, batchFolder(), request.force);
    out.collect([&](const std::filesystem::path& folder) {
        writeFitTable(folder / "fits.csv", curves);
        writeFitJson(folder / "fits.json", batchJson(curves));
    });
    out.commit();
    for (const FittedCurve& curve : curves) {
        std::cout << printable(curve.error.empty()
                                   ? curve.file + ": " + nameOf(curve.found.verdict) + ", " +
                                         curve.found.reasons.front()
                                   : curve.error)
                  << '\n';
    }
    const std::vector<BatchStatistic> statistics = batchStatistics(curves);
    for (const BatchStatistic& row : statistics) {
        std::cout << "median " << row.key << ' ' << row.median << ' ' << row.unit << ", spread "
                  << row.spread << ", of " << row.count << " curves\n";
    }
    if (statistics.empty()) {
        throw Error("none of the " + std::to_string(curves.size()) + " curves could be fitted");
    }
}

/// @throw InputError where the file does not say what the method needs
double stiffnessBySader(const std::string& file) {
    const toml::table content = readToml(file);
    const TomlSection section(content, file, "");
    for (const char* key : {"length_m", "width_m", "resonance_hz", "q_factor"}) {
        if (!section.has(key)) {
            section.complain(key, "is missing, and Sader's method needs it");
        }
    }
    const CantileverGeometry lever = readProbe(file).lever;
    return saderStiffness(lever.length, lever.width, flexuralMode(lever, 1).frequency(),
                          lever.qualityFactor);
}

double stiffnessBySpectrum(const std::string& file, double temperature) {
    const ThermalSpectrum spectrum = readThermalSpectrum(file);
    const ThermalOscillator lever =
        fitThermalSpectrum(spectrum.frequency, spectrum.power, temperature);
    std::cout << printable(file) << ": resonance " << lever.resonance << " Hz, quality factor "
              << lever.quality << ", spring constant " << lever.stiffness << " N/m ± "
              << lever.stiffnessStd << " (scatter)\n";
    return lever.stiffness;
}

std::vector<AreaSample> areaOf(const std::string& file) {
    const TipAreaFunction function = readTipAreaFunction(file);
    std::vector<AreaSample> samples;
    for (std::size_t i = 0; i < function.depth.size(); ++i) {
        samples.push_back({function.depth[i], function.area[i]});
    }
    return samples;
}

void fit(FitRequest request) {
    requireOutputFolder(request.out, request.curves.size() > 1 ? batchFolder() : fitFolder(),
                        request.force);
    PreparationOptions& steps = request.fit.curve.preparation;
    if (!request.probe.empty()) {
        steps.stiffness = stiffnessBySader(request.probe);
        steps.stiffnessSource = ValueSource::File;
    }
    if (!request.spectrum.empty()) {
        steps.stiffness = stiffnessBySpectrum(request.spectrum, request.temperature);
        steps.stiffnessSource = ValueSource::Measured;
    }
    if (!request.area.empty()) {
        request.fit.curve.tip->area = areaOf(request.area);
    }
    request.curves.size() > 1 ? fitMany(request) : fitOne(request);
}

}  // namespace

void addFitCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "fit", "Identify sample and lever from measured force curves, and simulate them");
    const auto request = std::make_shared<FitRequest>();
    addFitOptions(*command, *request);
    command->callback([request] { fit(*request); });
}

}  // namespace asperity
