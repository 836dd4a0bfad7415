#include "app/reports/run/RunPage.h"

#include "app/program/JsonText.h"
#include "app/runs/RunFolder.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

std::string subtitleOf(const Scene& scene) {
    const SceneDescription& description = scene.description;
    const RoundTip tip = description.tip.shape();
    constexpr double kDegree = std::numbers::pi / 180.0;  // [rad]
    const std::string cone =
        tip.hasCone() ? formatted(" and a cone of %.3g degrees", tip.coneHalfAngle / kDegree) : "";
    return "Tip of " + formatSi(tip.radius, "m") + " radius" + cone + " on " +
           description.sample.material.name + "; " + sampleName(description.sample);
}

/// Adds the warnings that a reader must know before any number.
void addWarnings(PageContent& page, const ReportedRun& run) {
    if (!run.difference.empty()) {
        page.addParagraph("The replay differs from the recorded log: " + run.difference +
                              ". All numbers of this page are those of the replay.",
                          PageTone::Fault);
    }
    if (!run.state.empty()) {
        page.addParagraph(capitalized(run.state) + ".", PageTone::Caution);
    }
    const RunVerdict verdict = verdictOn(run.history);
    page.addParagraph(verdict.sentence +
                          (verdict.hasReasons ? " The reasons are under Validity." : ""),
                      verdict.tone);
}

}  // namespace

ReportPage runPage(const ReportedRun& run, const std::string& parent) {
    const Scene& scene = run.loaded.scene;
    ReportPage page{.name = run.name,
                    .title = "Run " + run.name,
                    .subtitle = subtitleOf(scene),
                    .parent = parent,
                    .content = {}};
    addWarnings(page.content, run);
    addCurves(page.content, run.history);
    const std::vector<BudgetedCycle> cycles = budgeted(scene, run.history.events().cycles);
    addForceCycles(page.content, cycles);
    addUncertainty(page.content, scene, cycles);
    addSample(page.content, run);
    addPictures(page.content, run);
    addValidity(page.content, run.history);
    addParameters(page.content, scene);
    addModel(page.content, run);
    addReproduction(page.content, run);
    return page;
}

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

std::string meanText(const std::optional<CycleMean>& mean, const SiScale& scale) {
    if (!mean) {
        return kNoValue;
    }
    return mean->isModelKnown ? measuredText(mean->reading, scale)
                              : noisyText(mean->reading, scale);
}

std::vector<PageCell> rowOf(const IndexedRun& run, const IndexScales& scales) {
    const bool touched = run.cycles > 0;
    return {{run.name, run.name},
            {run.sample},
            {run.material},
            {formatSi(run.tipRadius, "m")},
            {std::to_string(run.cycles)},
            {meanText(run.pullOff, scales.force)},
            {meanText(run.adhesionWork, scales.energy)},
            {touched ? numberText(run.maxIndentation, scales.length) : kNoValue},
            {run.validity}};
}

}  // namespace

IndexedRun indexed(const ReportedRun& run) {
    const SceneDescription& scene = run.loaded.scene.description;
    const std::vector<BudgetedCycle> cycles =
        budgeted(run.loaded.scene, run.history.events().cycles);
    return {.name = run.name,
            .sample = shortNameOf(scene.sample),
            .material = scene.sample.material.name,
            .tipRadius = scene.tip.radius,
            .cycles = static_cast<long>(cycles.size()),
            .pullOff = pullOffOf(cycles),
            .adhesionWork = adhesionWorkOf(cycles),
            .maxIndentation = maxIndentationOf(cycles),
            .validity = run.difference.empty() ? verdictOn(run.history).brief : "replay differs"};
}

ReportPage indexPage(const std::string& name, const std::vector<IndexedRun>& runs) {
    const IndexScales scales = scalesOf(runs);
    PageTable table{.columns = {{"Run"},
                                {"Scan or shape"},
                                {"Material"},
                                {"Tip radius", true},
                                {"Force cycles", true},
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
        "Pull-off force and work of adhesion: of one force cycle, of several their mean, with "
        "the "
        "standard deviation of one cycle by noise (of several: by scatter), model and calibration "
        "together; where it says noise, by noise or scatter alone: more is not known. Validity: "
        "whether the contact model holds, by the share of ticks; –: no such "
        "value.");
    return page;
}

namespace {

const char* const kFiles = "files";

std::vector<std::string> filesOf(const std::vector<std::string>& pages) {
    std::vector<std::string> files;
    for (const std::string& page : pages) {
        files.push_back(page + ".html");
        files.push_back(page + ".pdf");
    }
    return files;
}

/// A list may have been changed: nothing but pages of this folder is ever removed.
bool isPage(const std::string& name) {
    const std::filesystem::path path = name;
    const bool isBare = path.filename() == path && !name.empty();
    return isBare && (path.extension() == ".html" || path.extension() == ".pdf");
}

/// Files of the report that is there; none where there is no list, or one that cannot be read.
std::vector<std::string> earlierFiles(const std::filesystem::path& folder) {
    const nlohmann::json list = readJson(folder / kReportList);
    std::vector<std::string> files;
    if (!list.is_object() || !list.contains(kFiles) || !list[kFiles].is_array()) {
        return files;
    }
    for (const nlohmann::json& name : list[kFiles]) {
        if (name.is_string() && isPage(name.get<std::string>())) {
            files.push_back(name.get<std::string>());
        }
    }
    return files;
}

}  // namespace

FolderContent reportContent(const std::filesystem::path& folder,
                            const std::vector<std::string>& pages) {
    FolderContent content{.marks = {kReportList}, .own = {}, .guarded = {}};
    for (const std::vector<std::string>& files : {filesOf(pages), earlierFiles(folder)}) {
        for (const std::string& name : files) {
            if (std::ranges::find(content.own, name) == content.own.end()) {
                content.own.push_back(name);
            }
        }
    }
    return content;
}

void writeReportList(const std::filesystem::path& folder, const std::vector<std::string>& pages) {
    writeTextFile(folder / kReportList, jsonText(nlohmann::json{{kFiles, filesOf(pages)}}) + '\n');
}

}  // namespace asperity
