#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunHistory.h"

#include <string>

namespace asperity {

/// How far the results of a run hold.
struct Verdict {
    PageTone tone = PageTone::Plain;
    std::string brief;     ///< a few words, for a table
    std::string sentence;  ///< the same with numbers
};

[[nodiscard]] Verdict verdictOn(const RunHistory& history);

}  // namespace asperity
