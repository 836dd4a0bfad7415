#include "app/reports/run/RunIndex.h"

#include "app/reports/run/MeasuredText.h"
#include "app/reports/run/RunVerdict.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace asperity {

namespace {

const char* const kNoValue = "–";

/// One for all rows, so that they compare at sight.
struct IndexScales {
    SiScale force;
    SiScale energy;
    SiScale length;
};

IndexScales scalesOf(const std::vector<IndexedRun>& runs) {
    double force = 0.0;
    double energy = 0.0;
    double length = 0.0;
    for (const IndexedRun& run : runs) {
        force = std::max(force, run.pullOff ? std::abs(run.pullOff->reading.value) : 0.0);
        energy =
            std::max(energy, run.adhesionWork ? std::abs(run.adhesionWork->reading.value) : 0.0);
        length = std::max(length, run.maxIndentation);
    }
    return {siScaleFor(force, "N"), siScaleFor(energy, "J"), siScaleFor(length, "m")};
}

/// Its page has the channel, too.
std::string shortNameOf(const SampleDescription& sample) {
    return sample.shape ? sampleName(sample)
                        : std::filesystem::path(sample.file).filename().string();
}

std::string meanText(const std::optional<TouchMean>& mean, const SiScale& scale) {
    if (!mean) {
        return kNoValue;
    }
    return mean->isModelKnown ? measuredText(mean->reading, scale)
                              : noisyText(mean->reading, scale);
}

std::vector<PageCell> rowOf(const IndexedRun& run, const IndexScales& scales) {
    const bool touched = run.touches > 0;
    return {{run.name, run.name},
            {run.sample},
            {run.material},
            {formatSi(run.tipRadius, "m")},
            {std::to_string(run.touches)},
            {meanText(run.pullOff, scales.force)},
            {meanText(run.adhesionWork, scales.energy)},
            {touched ? numberText(run.maxIndentation, scales.length) : kNoValue},
            {run.validity}};
}

}  // namespace

IndexedRun indexed(const ReportedRun& run) {
    const SceneDescription& scene = run.loaded.scene.description;
    const std::vector<BudgetedTouch> touches =
        budgeted(run.loaded.scene, run.history.events().cycles);
    return {.name = run.name,
            .sample = shortNameOf(scene.sample),
            .material = scene.sample.material.name,
            .tipRadius = scene.tip.radius,
            .touches = static_cast<long>(touches.size()),
            .pullOff = pullOffOf(touches),
            .adhesionWork = adhesionWorkOf(touches),
            .maxIndentation = maxIndentationOf(touches),
            .validity = run.difference.empty() ? verdictOn(run.history).brief : "replay differs"};
}

ReportPage indexPage(const std::string& name, const std::vector<IndexedRun>& runs) {
    const IndexScales scales = scalesOf(runs);
    PageTable table{.columns = {{"Run"},
                                {"Scan or shape"},
                                {"Material"},
                                {"Tip radius", true},
                                {"Touches", true},
                                {"Pull-off force [" + scales.force.unit + "]", true},
                                {"Work of adhesion [" + scales.energy.unit + "]", true},
                                {"Max. indentation [" + scales.length.unit + "]", true},
                                {"Validity"}},
                    .rows = {}};
    for (const IndexedRun& run : runs) {
        table.rows.push_back(rowOf(run, scales));
    }
    ReportPage page{.name = name,
                    .title = "Report on " + std::to_string(runs.size()) + " runs",
                    .subtitle = "A row each; its name leads to its page",
                    .parent = "",
                    .content = {}};
    page.content.addTable(std::move(table));
    page.content.addParagraph(
        "Pull-off force and work of adhesion: of one touch, of several touches their mean, with "
        "the "
        "standard deviation of one touch by noise (of several: by scatter), model and calibration "
        "together; where it says noise, by noise or scatter alone: more is not known. Validity: "
        "whether the contact model holds, by the share of ticks; –: no such "
        "value.");
    return page;
}

}  // namespace asperity
