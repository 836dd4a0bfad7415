#include "app/commands/Commands.h"
#include "app/commands/FitOptions.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/curves/CurveFit.h"
#include "app/curves/FitBatch.h"
#include "app/curves/FitFiles.h"
#include "app/curves/FitMap.h"
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
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

namespace {

FolderContent batchFolder() {
    return {.marks = {"fits.csv"}, .own = {"fits.json", "maps.gwy"}, .guarded = {"fits.csv"}};
}

void printSummary(const FittedCurve& curve) {
    for (const std::string& line : fitSummary(curve)) {
        std::cout << printable(line) << '\n';
    }
}

/// @throw Error where the curve was refused, after its files are written
void fitOne(const FitRequest& request) {
    const FittedCurve curve = fittedCurve(request.curves.front(), request.read.index.value_or(0),
                                          request.read.read, request.fit);
    const bool refused = curve.found.verdict == FitVerdict::Refused;
    const std::string noScene = refusalOfScene(curve);
    OutputFolder out(request.out, fitFolder(), request.force);
    out.collect([&](const std::filesystem::path& folder) {
        const OffscreenApplication qt;  // the figure needs its fonts
        writeFitFiles(folder, curve);
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

/// Keeps what tables and maps need: a map would not have room for the samples of its curves.
FittedCurve withoutSamples(FittedCurve curve) {
    curve.found.approach = {};
    curve.found.retract = {};
    return curve;
}

/// Fits one curve of each file; one that cannot be read ends nothing.
std::vector<FittedCurve> fittedFiles(const FitRequest& request) {
    std::vector<FittedCurve> curves(request.curves.size());
    ProgressLine line("fitting");
    shareOut(static_cast<int>(curves.size()), &line, [&](int index, const CancelCheck&) {
        const auto i = static_cast<std::size_t>(index);
        const std::string& path = request.curves[i];
        try {
            curves[i] = withoutSamples(
                fittedCurve(path, request.read.index.value_or(0), request.read.read, request.fit));
        } catch (const FileError& error) {
            curves[i] = {.file = path, .sha256 = {}, .error = error.what()};
        }
    });
    return curves;
}

/// Fits all curves of a file; one that is damaged ends nothing.
FitMap fittedMap(const std::string& path, const FitRequest& request) {
    try {
        const FileBytes bytes(path);
        const ForceCurveFile file(bytes, request.read.read);
        const std::string sha256 = sha256Of(bytes);
        FitMap map{.grid = file.grid(), .curves = std::vector<FittedCurve>(file.count())};
        ProgressLine line("fitting");
        shareOut(static_cast<int>(file.count()), &line, [&](int i, const CancelCheck&) {
            const auto index = static_cast<std::size_t>(i);
            FittedCurve& curve = map.curves[index];
            try {
                curve = withoutSamples(fittedCurve(path, file, index, request.fit));
            } catch (const FileError& error) {
                curve = {.file = path, .index = index, .sha256 = {}, .error = error.what()};
            }
            curve.sha256 = sha256;
        });
        return map;
    } catch (const FileError& error) {
        return {.grid = {}, .curves = {{.file = path, .sha256 = {}, .error = error.what()}}};
    }
}

void printVerdicts(const std::vector<FittedCurve>& curves) {
    constexpr std::size_t kFew = 20;
    for (std::size_t i = 0; i < std::min(curves.size(), kFew); ++i) {
        const FittedCurve& curve = curves[i];
        std::cout << printable(curve.error.empty()
                                   ? curve.file + ", curve " + std::to_string(curve.index) + ": " +
                                         nameOf(curve.found.verdict) + ", " +
                                         curve.found.reasons.front()
                                   : curve.error)
                  << '\n';
    }
    if (curves.size() > kFew) {
        std::cout << "... and " << curves.size() - kFew << " more, see fits.csv\n";
    }
}

/// Writes the tables, and the images of a map where there is no reason against them.
void writeBatch(const FitRequest& request, const FitMap& map, const std::string& noMap) {
    OutputFolder out(request.out, batchFolder(), request.force);
    out.collect([&](const std::filesystem::path& folder) {
        writeFitTable(folder / "fits.csv", map.curves);
        writeFitJson(folder / "fits.json", batchJson(map.curves));
        if (noMap.empty()) {
            writeFitMap(folder / "maps.gwy", map);
        }
    });
    out.commit();
}

/// @throw Error where no curve could be fitted, after the table is written
void fitMany(const FitRequest& request) {
    const CancelOnSignal cancel;
    FitMap map;
    std::string noMap = "several files were asked for";
    if (!request.all) {
        map.curves = fittedFiles(request);
    } else if (request.curves.size() == 1) {
        map = fittedMap(request.curves.front(), request);
        noMap = refusalOfMap(map);
    } else {
        for (const std::string& path : request.curves) {
            std::ranges::move(fittedMap(path, request).curves, std::back_inserter(map.curves));
        }
    }
    writeBatch(request, map, noMap);
    printVerdicts(map.curves);
    const std::vector<BatchStatistic> statistics = batchStatistics(map.curves);
    for (const BatchStatistic& row : statistics) {
        std::cout << "median " << row.key << ' ' << row.median << ' ' << row.unit << ", spread "
                  << row.spread << ", of " << row.count << " curves\n";
    }
    if (request.all && !noMap.empty()) {
        std::cout << "no maps.gwy: " << noMap << '\n';
    }
    if (statistics.empty()) {
        throw Error("none of the " + std::to_string(map.curves.size()) + " curves could be fitted");
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
    const bool isBatch = request.all || request.curves.size() > 1;
    requireOutputFolder(request.out, isBatch ? batchFolder() : fitFolder(), request.force);
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
    isBatch ? fitMany(request) : fitOne(request);
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
