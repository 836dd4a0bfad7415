#pragma once

#include "core/contact/laws/ContactModel.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A contact law and how it is solved.
struct LawOption {
    ContactLaw law = ContactLaw::Hertz;
    SolverSetting solver = SolverSetting::Exact;
};

/// Every law, first solved afresh; the other settings where they are anything else.
[[nodiscard]] std::vector<LawOption> lawOptions();

/// "exact", "newton", "table", as scene files call them; "-" where all are the same.
[[nodiscard]] const char* solverName(const LawOption& lawOption) noexcept;

/// Sample, tip and lever that a law is asked about.
struct ContactSetting {
    ContactPair pair;
    double filmThickness = 0.0;   ///< [m]; 0: a half-space
    double leverStiffness = 1.0;  ///< [N/m]; infinite: displacement control
    double cohesiveStress = 0.0;  ///< [Pa]; 0: as ContactOptions has it
    double filmPoissonRatio = 0.5;

    [[nodiscard]] double compliance() const noexcept { return 1.0 / leverStiffness; }
};

/// All of it with 17 digits, so that the state can be repeated.
[[nodiscard]] std::string describe(const LawOption& lawOption, const ContactSetting& setting,
                                   double approach);

/// A model, or why there is none.
struct ContactCandidate {
    LawOption lawOption;
    std::optional<ContactModel> model;
    std::string refusal;
};

[[nodiscard]] ContactCandidate candidate(const LawOption& lawOption, const ContactSetting& setting);

/// Why a state was refused, for people. @param status not Solved
[[nodiscard]] std::string refusalOf(ContactStatus status);

}  // namespace asperity
