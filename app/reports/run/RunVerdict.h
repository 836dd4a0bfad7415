#pragma once

#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunHistory.h"

#include <string>

namespace asperity {

/// How far the results of a run hold.
struct RunVerdict {
    PageTone tone = PageTone::Plain;
    std::string brief;        ///< a few words, for a table
    std::string sentence;     ///< the same with numbers
    bool hasReasons = false;  ///< they are in the section on validity
};

[[nodiscard]] RunVerdict verdictOn(const RunHistory& history);

}  // namespace asperity
