#include "app/reports/run/ModelSection.h"

#include "core/FormattedText.h"
#include "core/words/ModelWords.h"

#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// Without a summary: as the scene has them, where all are settled.
std::vector<RecordedTerm> settledTerms(const SceneNeeds& needs) {
    std::vector<RecordedTerm> terms;
    for (const TermNeed& need : needs.terms) {
        terms.push_back({.name = nameOf(need.term),
                         .on = need.on,
                         .overruled = true,
                         .effect = need.effect,
                         .why = whyOf(need, needs)});
    }
    return terms;
}

std::string effectText(double effect) {
    const double percent = 100.0 * effect;
    return formatted(percent < 99.5 ? "%.2g\u00A0%%" : "%.0f\u00A0%%", percent);
}

PageTable termTable(const std::vector<RecordedTerm>& terms) {
    PageTable table{
        .columns = {{"Term"}, {"In the model"}, {"Effect", true}, {"Decided by"}, {"Why"}},
        .rows = {}};
    for (const RecordedTerm& term : terms) {
        table.rows.push_back({{term.name},
                              {term.on ? "yes" : "left out"},
                              {effectText(term.effect)},
                              {term.overruled ? "scene" : "fit"},
                              {term.why}});
    }
    return table;
}

}  // namespace

void addModel(PageContent& page, const ReportedRun& run) {
    const LoadedScene& loaded = run.loaded;
    const bool isRecorded = run.summary && !run.summary->terms.empty();
    page.addHeading("Model");
    page.addParagraph(std::string("Contact law: ") + nameOf(loaded.scene.model.law) +
                      ". Model: " + nameOf(loaded.scene.model) + ".");
    page.addList(run.summary ? run.summary->notes : notesOn(loaded));
    page.addTable(termTable(isRecorded ? run.summary->terms : settledTerms(loaded.needs)));
    page.addParagraph(
        "Effect: what leaving the term out changes of the quantity that it changes most, in "
        "sampled runs and force curves, as a share of that; of a position as a share of the base's "
        "travel from setpoint to pull-off. Fit: the term is in where that exceeds the tolerance "
        "of the scene. Scene: it decides itself.");
    if (!isRecorded) {
        page.addParagraph(
            "The run has no summary with the reasons: these are the choices that its scene keeps.");
    }
}

}  // namespace asperity
