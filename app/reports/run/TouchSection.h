#pragma once

#include "app/reports/page/ReportPage.h"
#include "core/haptics/cycle/ContactCycle.h"

#include <optional>
#include <vector>

namespace asperity {

/// A value over the touches of a run that have it: of one that value, of several their mean and the
/// standard deviation of one of them. None: no touch has it.
struct TouchMean {
    Reading reading;
    long touches = 0;
};

[[nodiscard]] std::optional<TouchMean> pullOffOf(const std::vector<ContactCycle>& cycles);
[[nodiscard]] std::optional<TouchMean> adhesionWorkOf(const std::vector<ContactCycle>& cycles);
[[nodiscard]] double maxIndentationOf(const std::vector<ContactCycle>& cycles);  ///< [m]

/// What the touches of a run show, with the values of `cycles` in summary.json.
void addTouches(PageContent& page, const std::vector<ContactCycle>& cycles);

}  // namespace asperity
