#pragma once

#include "core/ShareOut.h"
#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/studies/extremes/ExtremesRegion.h"
#include "core/studies/extremes/ExtremesStudy.h"

#include <cstddef>
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

/// Returns why a state was refused, for people. @param status not Solved
[[nodiscard]] std::string refusalOf(ContactStatus status);

/// One position of the undeflected tip on its approach or retraction.
struct ContactStop {
    double approach = 0.0;  ///< [m]
    bool retract = false;
};

/// Returns stops from beyond both jumps of the reference to three tip radii of indentation and
/// back; inwards of the first touch the lever's base is moved as far as Hertz' force bends the
/// lever.
/// @param positions one way, >= 4
[[nodiscard]] std::vector<ContactStop> contactStops(const ContactModel& reference,
                                                    const ContactSetting& setting, int positions);

/// The states of a law at all stops.
struct ContactCourse {
    std::vector<ContactState> states;  ///< each with the memory of the one before, as in a run
    double jumpIn = 0.0;               ///< approach of the undeflected tip [m]
    double pullOff = 0.0;              ///< same [m]
};

[[nodiscard]] ContactCourse contactCourse(const ContactModel& model,
                                          const std::vector<ContactStop>& stops, double compliance);

struct FlatSample {
    double modulus = 0.0;   ///< E* [Pa]
    double adhesion = 0.0;  ///< w [J/m^2]
    Film film = {};         ///< by default a half-space
};

/// All samples of the grid.
[[nodiscard]] std::vector<FlatSample> samplesOf(const ContactGrid& grid);

/// All states of the grid on one sample.
///
/// The reference is Maugis-Dugdale on the exact sphere, which has every other law on a half-space
/// as a limit, on a film `hertz_film`. Where a flag says that the reference does not hold, and
/// before contact for `split`, whose tail it lacks, nothing is known of a law's error.
/// @throw Canceled
[[nodiscard]] ExtremesFindings contactExtremes(const ContactGrid& grid, const FlatSample& sample,
                                               const CancelCheck& check);

/// Returns the defect of a solved state: "a value is not finite", "lever and sample are not in
/// balance"; null where all is well. @param approach of the undeflected tip [m]
[[nodiscard]] const char* defectOf(const ContactState& state, const ContactSetting& setting,
                                   double approach) noexcept;

/// Returns the relative errors of a state, by the larger of both and `units`.
[[nodiscard]] StateErrors stateErrors(const ContactState& state, const ContactState& reference,
                                      const MaugisUnits& units) noexcept;

/// Returns the errors of a course's state at one stop against another course's. Where one has
/// jumped and the other has not, their forces say nothing of the law's error: then the positions of
/// the two jumps are compared, relative to the farther one.
[[nodiscard]] StateErrors contactErrors(const ContactCourse& course, const ContactCourse& other,
                                        const std::vector<ContactStop>& stops, std::size_t index,
                                        const MaugisUnits& units) noexcept;

/// Every law at parameters that no instrument has: all must be refused.
[[nodiscard]] ExtremesFindings refusedContacts();

}  // namespace asperity
