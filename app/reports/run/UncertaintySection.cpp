#include "app/reports/run/UncertaintySection.h"

#include "app/reports/run/MeasuredText.h"
#include "core/scene/Scene.h"
#include "core/words/BudgetWords.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

void addUncertainty(PageContent& page, const Scene& scene,
                    const std::vector<BudgetedTouch>& touches) {
    if (!scene.description.uncertainty.enabled || touches.empty()) {
        return;
    }
    PageTable table{.columns = {{"touch", true}, {"What"}, {"Value"}, {"Most by"}}, .rows = {}};
    for (std::size_t i = 0; i < touches.size(); ++i) {
        for (const auto& [key, name, unit, budget] : touches[i].budgets) {
            table.rows.push_back(
                {{std::to_string(i + 1)}, {name}, {budgetText(budget, unit)}, {mostBy(budget)}});
        }
    }
    std::vector<std::string> remarks;
    for (const BudgetedTouch& touch : touches) {
        for (const auto& [key, name, unit, budget] : touch.budgets) {
            const std::string remark = resolutionText(budget, name, scene.description.tolerance);
            if (!remark.empty() && std::ranges::find(remarks, remark) == remarks.end()) {
                remarks.push_back(remark);
            }
        }
    }
    const bool isAllKnown = std::ranges::all_of(touches, [](const BudgetedTouch& touch) {
        return std::ranges::all_of(touch.budgets, [](const CycleBudget& one) {
            return unknownText(one.budget, one.name).empty();
        });
    });
    page.addHeading("Uncertainty");
    page.addTable(table);
    page.addParagraph(
        "The first deviation is the noise of the signals. The second is what lever, "
        "tip, material, calibration and the way from the scan to the effective "
        "radius leave open, by the scene's section [uncertainty]; in brackets the "
        "inputs that make up most of it. A third, where it matters, is what the "
        "terms do that the model leaves out. All are one standard deviation, about the "
        "value less what it is said to be too high by." +
        std::string(isAllKnown ? ""
                               : " A ? is a deviation that is not known, for the reason beside it; "
                                 "what is stated is then not the whole."));
    for (const std::string& remark : remarks) {
        page.addParagraph(capitalized(remark + "."));
    }
}

}  // namespace asperity
