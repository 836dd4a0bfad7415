#pragma once

#include "core/haptics/cycle/CurveBranch.h"
#include "core/uncertainty/CycleBudgets.h"

#include <QString>

#include <filesystem>
#include <vector>

namespace asperity {

/// A force cycle of the tip, and its sample.
struct ForceCycle {
    ContactCycle cycle;
    QString material;
    QString scan;  ///< name of the file or shape
    /// Budgets of its readings, once it is complete: they outlive the scene.
    std::vector<CycleBudget> budgets;
};

/// Writes force cycles as a CSV table in SI units, one row each; a cell is empty where the cycle
/// has no such value. Columns are named as the keys of `cycles` in summary.json
/// (docs/measuring.md).
/// @throw Error when it cannot be written; then the file stays as it was
void writeForceCycles(const std::filesystem::path& file, const std::vector<ForceCycle>& cycles);

}  // namespace asperity
