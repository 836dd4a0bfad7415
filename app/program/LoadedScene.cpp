#include "app/program/LoadedScene.h"

#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/probe/SimulatedAfm.h"
#include "core/probe/recorded/RecordedAfm.h"
#include "core/scene/BelievedModel.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace asperity {

namespace {

void line(std::ostream& out, const char* caption, const std::string& value) {
    out << caption << ": " << printable(value) << '\n';
}

std::string lengths(double x, double y) { return formatSi(x, "m") + " x " + formatSi(y, "m"); }

std::string counts(int x, int y) { return std::to_string(x) + " x " + std::to_string(y); }

void addFile(std::ostream& out, const LoadedScene& loaded) {
    const SampleDescription& sample = loaded.scene.description.sample;
    if (sample.shape) {
        line(out, "Sample", "an exact shape, no file");
        return;
    }
    line(out, "File", sample.file);
    line(out, "Format", loaded.format);
    line(out, "SHA-256", loaded.sha256);
    line(out, "Channel", sample.channel);
}

void addPixels(std::ostream& out, const LoadedScene& loaded) {
    const BSplineSurface& surface = loaded.scene.surface;
    const BSplineSurface::Grid& grid = surface.grid();
    line(out, "Pixels", counts(grid.columns, grid.rows));
    line(out, "Size", lengths(surface.sizeX(), surface.sizeY()));
    line(out, "Pixel", lengths(grid.pitchX, grid.pitchY));
    line(out, "Pixels without data, filled in", std::to_string(loaded.filledPixels));
}

}  // namespace

std::vector<std::string> notesOn(const LoadedScene& loaded) {
    std::vector<std::string> notes = loaded.notes;
    std::ranges::move(forceNotes(loaded.scene, loaded.needs), std::back_inserter(notes));
    return notes;
}

std::string scanReport(const LoadedScene& loaded) {
    std::ostringstream out;
    addFile(out, loaded);
    addPixels(out, loaded);
    out << "\nWhat was decided\n";
    for (const std::string& note : notesOn(loaded)) {
        out << "- " << printable(note) << '\n';
    }
    if (!loaded.provenance.empty()) {
        out << "\nWhere the numbers come from\n";
        for (const Provenance& entry : loaded.provenance) {
            out << "- " << printable(entry.what + ": " + entry.value) << " ("
                << printable(entry.source) << ")\n";
        }
    }
    return out.str();
}

std::unique_ptr<AfmController> instrumentOf(const Scene& scene) {
    if (scene.maps.curve != nullptr) {
        return std::make_unique<RecordedAfm>(scene.maps.curve, scene.trueSurface(),
                                             scene.description.tip.radius, scene.belief.cantilever);
    }
    return std::make_unique<SimulatedAfm>(scene.trueSurface(), truthOf(scene));
}

}  // namespace asperity
