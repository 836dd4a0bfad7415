#pragma once

#include "core/haptics/cycle/ContactCycle.h"
#include "core/uncertainty/CycleBudgets.h"

#include <QString>

#include <vector>

namespace asperity {

/// One touch of the tip: what its cycle shows, and of which sample.
struct Touch {
    ContactCycle cycle;
    QString material;
    QString scan;  ///< name of the file or shape
    /// Of its readings, once it is complete: the scene goes, the touch stays.
    std::vector<CycleBudget> budgets;
};

}  // namespace asperity
