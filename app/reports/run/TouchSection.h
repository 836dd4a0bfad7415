#pragma once

#include "app/reports/page/ReportPage.h"
#include "core/uncertainty/CycleBudgets.h"

#include <optional>
#include <vector>

namespace asperity {

/// A touch with what is open in its readings.
struct BudgetedTouch {
    ContactCycle cycle;
    std::vector<CycleBudget> budgets;
};

[[nodiscard]] std::vector<BudgetedTouch> budgeted(const Scene& scene,
                                                  const std::vector<ContactCycle>& cycles);

/// A value over the touches of a run that have it, with its standard deviation by noise, model and
/// calibration together: of one that value, of several their mean and the deviation of one of them,
/// by their scatter in the place of the noise. None: no touch has it.
struct TouchMean {
    Reading reading;
    long touches = 0;
    bool isModelKnown = true;  ///< false: the deviation is by noise or scatter alone
};

[[nodiscard]] std::optional<TouchMean> pullOffOf(const std::vector<BudgetedTouch>& touches);
[[nodiscard]] std::optional<TouchMean> adhesionWorkOf(const std::vector<BudgetedTouch>& touches);
[[nodiscard]] double maxIndentationOf(const std::vector<BudgetedTouch>& touches);  ///< [m]

/// What the touches of a run show, with the values of `cycles` in summary.json.
void addTouches(PageContent& page, const std::vector<BudgetedTouch>& touches);

}  // namespace asperity
