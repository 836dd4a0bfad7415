#pragma once

#include "core/EnumTable.h"
#include "core/identify/cycle/MeasuredCycle.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Explanations of a cycle that are compared.
enum class CycleModel : std::uint8_t {
    Elastic,
    JkrOne,
    JkrTwo,
    Maugis,
    Relaxation,
    Drag,
    RelaxationDrag,
};

template <>
inline constexpr auto kEnumTable<CycleModel> = std::to_array<EnumRow<CycleModel>>(
    {{CycleModel::Elastic, "elastic", "elastic"},
     {CycleModel::JkrOne, "jkr_one", "JKR, one work of adhesion"},
     {CycleModel::JkrTwo, "jkr_two", "JKR, two works of adhesion"},
     {CycleModel::Maugis, "md", "Maugis-Dugdale"},
     {CycleModel::Relaxation, "relaxation", "relaxation"},
     {CycleModel::Drag, "drag", "elastic with wall drag"},
     {CycleModel::RelaxationDrag, "relaxation_drag", "relaxation with wall drag"}});

/// Tip and sample for a comparison.
struct ComparisonOptions {
    double tipRadius = 0.0;     ///< [m]
    bool sphere = true;         ///< exact, not its paraboloid
    double poissonRatio = 0.5;  ///< of the sample
};

/// One explanation, fitted. Root mean squares are shares of the force range.
struct ComparedModel {
    CycleModel model = CycleModel::Elastic;
    double rms = 0.0;                      ///< of both branches, both seen
    double criterion = 0.0;                ///< BIC, less that of the best
    std::optional<double> unseenApproach;  ///< rms there, identified from the retract
    std::optional<double> unseenRetract;   ///< rms there, identified from the approach; none: that
                                           ///< does not show a parameter
    std::vector<std::string> notIdentified;  ///< keys of parameters, both branches seen
};

/// Outcome of a comparison.
struct ModelComparison {
    std::vector<ComparedModel> ranked;  ///< the best first
    std::optional<CycleModel> best;     ///< none: undecided
    std::vector<std::string> reasons;   ///< why it is undecided, and what was not compared
    double independentSamples = 0.0;    ///< the samples less those that only repeat others' errors
};

/// Fits all explanations that the cycle can carry to the same samples, those by a jump left out,
/// and ranks them by Schwarz's information criterion (BIC) with the number of independent samples.
/// A special case of the best that is worse by less than 6 counts as the best. Undecided where
/// another one, but for the best with additions, is not worse by more than 10 or predicts an unseen
/// branch clearly better. Sources: Schwarz (1978); Kass, Raftery (1995).
/// @throw Error where the cycle has no contact
[[nodiscard]] ModelComparison compareModels(const MeasuredCycle& cycle,
                                            const ComparisonOptions& options);

}  // namespace asperity
