#include "app/reports/run/RunPage.h"

#include "app/reports/run/CurveSection.h"
#include "app/reports/run/MeasuredText.h"
#include "app/reports/run/ModelSection.h"
#include "app/reports/run/ParameterSection.h"
#include "app/reports/run/PictureSection.h"
#include "app/reports/run/ReproductionSection.h"
#include "app/reports/run/RunVerdict.h"
#include "app/reports/run/SampleSection.h"
#include "app/reports/run/TouchSection.h"
#include "app/reports/run/UncertaintySection.h"
#include "app/reports/run/ValiditySection.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/words/SceneWords.h"

#include <numbers>
#include <string>
#include <vector>

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

/// What a reader must know before any number.
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
    const std::vector<BudgetedTouch> touches = budgeted(scene, run.history.events().cycles);
    addTouches(page.content, touches);
    addUncertainty(page.content, scene, touches);
    addSample(page.content, run);
    addPictures(page.content, run);
    addValidity(page.content, run.history);
    addParameters(page.content, scene);
    addModel(page.content, run);
    addReproduction(page.content, run);
    return page;
}

}  // namespace asperity
