#include "app/reports/run/SampleSection.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/Utf8.h"
#include "core/words/ImagingTipWords.h"
#include "core/words/LevelingWords.h"
#include "core/words/SceneWords.h"

#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// What a file says of itself may be long.
std::string shortened(const std::string& text) {
    constexpr std::size_t kMost = 400;
    return text.size() <= kMost ? text : std::string(utf8Start(text, kMost)) + " …";
}

void addFact(PageTable& facts, const char* name, const std::string& value) {
    facts.rows.push_back({{name}, {shortened(value)}});
}

PageTable factTable() {
    return {.columns = {{"quantity"}, {"value"}}, .rows = {}, .hasTitles = false};
}

std::string pair(double x, double y) { return formatSi(x, "m") + " × " + formatSi(y, "m"); }

std::string placeText(const Vector3& place) {
    return "x = " + formatSi(place.x(), "m") + ", y = " + formatSi(place.y(), "m");
}

std::string levelingText(const Scene& scene) {
    std::string text;
    for (const std::string& note : levelingNotes(scene.removedBySteps)) {
        const std::size_t name = note.find(": ");  // "leveling, step 1 of 2: "
        text +=
            (text.empty() ? "" : "; ") + (name == std::string::npos ? note : note.substr(name + 2));
    }
    return text;
}

std::string smoothingText(const SampleDescription& sample) {
    if (sample.smoothingLength > 0.0) {
        return "Gaussian, standard deviation " + formatSi(sample.smoothingLength, "m");
    }
    const double pixels = sample.smoothingPixels.value_or(0.0);
    return pixels > 0.0 ? formatted("Gaussian, standard deviation %.3g pixels", pixels)
                        : std::string("none");
}

void addScan(PageTable& facts, const ReportedRun& run) {
    const LoadedScene& loaded = run.loaded;
    const SampleDescription& sample = loaded.scene.description.sample;
    addFact(facts, "File",
            run.bundle ? run.scan + " in the bundle " + run.folder.filename().string() : run.scan);
    addFact(facts, "Format", loaded.format);
    addFact(facts, "SHA-256", loaded.sha256);
    addFact(facts, "Channel", sample.channel);
    const BSplineSurface& surface = loaded.scene.surface;
    const BSplineSurface::Grid& grid = surface.grid();
    addFact(facts, "Size", pair(surface.sizeX(), surface.sizeY()));
    addFact(facts, "Pixels",
            std::to_string(grid.columns) + " × " + std::to_string(grid.rows) + ", each " +
                pair(grid.pitchX, grid.pitchY) + "; " + std::to_string(loaded.filledPixels) +
                " without data, filled in");
    if (const auto& crop = sample.crop) {
        addFact(facts, "Part of the scan",
                formatted("from column %d, row %d", crop->column, crop->row));
    }
    addFact(facts, "Leveling", levelingText(loaded.scene));
    addFact(facts, "Smoothing", smoothingText(sample));
    addFact(facts, "Height noise", formatSi(loaded.scene.heightNoise, "m"));
}

void addPlaces(PageTable& facts, const RunEvents& events) {
    if (!events.cycles.empty()) {
        const ContactCycle& first = events.cycles.front();
        addFact(facts, first.fromStart ? "In contact from the start at" : "First contact",
                placeText({first.place.x(), first.place.y(), 0.0}));
        addFact(facts, "Deepest contact", placeText(events.deepest->output.model.tip));
    } else if (events.deepest) {
        addFact(facts, "Nearest to the sample", placeText(events.deepest->output.model.tip));
    }
}

PageTable provenanceTable(const std::vector<Provenance>& provenance) {
    PageTable table{.columns = {{"What"}, {"Value"}, {"Where from"}}, .rows = {}};
    for (const Provenance& entry : provenance) {
        table.rows.push_back({{entry.what}, {shortened(entry.value)}, {shortened(entry.source)}});
    }
    return table;
}

}  // namespace

void addSample(PageContent& page, const ReportedRun& run) {
    const SampleDescription& sample = run.loaded.scene.description.sample;
    PageTable facts = factTable();
    if (sample.shape) {
        addFact(facts, "Shape", sampleName(sample));
    } else {
        addScan(facts, run);
    }
    addFact(facts, "Imaging tip", imagingTipWords(run.loaded.scene));
    addFact(facts, "Material", sample.material.name);
    addPlaces(facts, run.history.events());
    page.addHeading("Sample");
    page.addTable(std::move(facts));
    page.addPicture({run.overview, "The sample in 3-D, with the place of the tip",
                     "Places count from the lower left corner of the scan, x to the right, y up "
                     "in the image."});
    if (!run.loaded.provenance.empty()) {
        page.addHeading("Where the numbers of the scan come from");
        page.addTable(provenanceTable(run.loaded.provenance));
    }
}

}  // namespace asperity
