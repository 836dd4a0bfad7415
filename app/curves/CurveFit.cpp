#include "app/curves/CurveFit.h"

#include "app/curves/FitScene.h"
#include "core/io/FileBytes.h"

#include <utility>

namespace asperity {

FittedCurve fittedCurve(const std::string& path, const ForceCurveFile& file, std::size_t index,
                        const CycleFitOptions& options) {
    CurveContents contents = file.contents(index);
    FittedCurve curve{.file = path, .index = index, .sha256 = {}};
    curve.position = file.position(index);
    curve.cell = file.cell(index);
    curve.heightChannel = std::move(contents.heightChannel);
    curve.notes = file.notes();
    curve.notes.insert(curve.notes.end(), contents.notes.begin(), contents.notes.end());
    curve.found = identifyCurve(contents.curve, options);
    if (options.compares && curve.found.verdict != FitVerdict::Refused) {
        curve.comparison = compareCurve(contents.curve, options);
    }
    return curve;
}

FittedCurve fittedCurve(const std::string& path, std::size_t index, const CurveReadOptions& read,
                        const CycleFitOptions& options) {
    const FileBytes bytes(path);
    FittedCurve curve = fittedCurve(path, ForceCurveFile(bytes, read), index, options);
    curve.sha256 = sha256Of(bytes);
    return curve;
}

FolderContent fitFolder() {
    return {.marks = {"fit.json"},
            .own = {"curve.csv", "simulated.csv", "fit.png", "material.toml", "probe.toml",
                    "scene.toml"},
            .guarded = {"fit.json"}};
}

void writeFitFiles(const std::filesystem::path& folder, const FittedCurve& curve) {
    writeFitJson(folder / "fit.json", fitJson(curve));
    if (curve.found.verdict != FitVerdict::Refused) {
        writeMeasuredCurve(folder / "curve.csv", curve);
        writeSimulatedCurve(folder / "simulated.csv", curve);
        writeFitFigure(folder / "fit.png", curve);
    }
    if (refusalOfScene(curve).empty()) {
        writeFitScene(folder, curve);
    }
}

}  // namespace asperity
