#include "app/commands/CaseFiles.h"
#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "core/Error.h"
#include "core/Version.h"
#include "core/contact/Within.h"
#include "core/contact/laws/ContactModel.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/tables/CaseTable.h"
#include "core/scene/TipValidity.h"

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// One row of the table.
struct ContactCase {
    ContactLaw law = {};
    ContactPair pair;
    double cohesiveStress = 0.0;  ///< [Pa]
    double filmThickness = 0.0;   ///< [m]; 0: a half-space
    double poissonRatio = kNaN;   ///< of the film
    double coneHalfAngle = 0.0;   ///< of the tip [rad]; 0: no cone
    double indentation = 0.0;     ///< [m]
    ContactBranch branch = ContactBranch::Far;
};

/// The result.
struct ContactAnswer {
    std::string status;
    std::optional<ContactState> state = {};  ///< none where there is no answer
    double lambda = kNaN;
};

/// A number of the cases whose relative standard deviation a table may state.
struct DeviationColumn {
    const char* column;
    double ContactPair::*number;
    const char* name;  ///< for people
};
constexpr auto kDeviations = std::to_array<DeviationColumn>(
    {{"radius_deviation", &ContactPair::tipRadius, "radius"},
     {"e_star_deviation", &ContactPair::reducedModulus, "e_star"},
     {"work_of_adhesion_deviation", &ContactPair::workOfAdhesion, "work_of_adhesion"}});
using CaseDeviations = std::array<double, kDeviations.size()>;

/// The deviation of the force that they cause.
struct ForceDeviation {
    double sigma = 0.0;       ///< [N]
    std::string by = "none";  ///< the number with the largest share
};

/// The number in a column that a table need not have.
double numberOr(const CsvTable& table, std::size_t row, const std::string& column,
                double otherwise) {
    return table.has(column) ? table.number(row, column) : otherwise;
}

/// Returns a cell's value. @throw InputError when it is none of the words that the column may hold
template <class Value>
Value wordIn(const CsvTable& table, std::size_t row, const std::string& column,
             const std::optional<Value>& value, const std::string& words) {
    if (!value) {
        throw InputError(table.file(),
                         "line " + std::to_string(table.line(row)) + ": column '" + column + "'",
                         "expected one of " + words + ", found '" + table.text(row, column) + "'");
    }
    return *value;
}

std::optional<ContactBranch> branchOf(const std::string& word) {
    const std::optional<CurveBranch> branch = fromKey<CurveBranch>(word);
    if (!branch) {
        return std::nullopt;
    }
    return *branch == CurveBranch::Approach ? ContactBranch::Far : ContactBranch::Bonded;
}

ContactCase readCase(const CsvTable& table, std::size_t row) {
    return {.law = wordIn(table, row, "model", fromKey<ContactLaw>(table.text(row, "model")),
                          keyList<ContactLaw>()),
            .pair = {.tipRadius = table.number(row, "radius_m"),
                     .reducedModulus = table.number(row, "e_star_pa"),
                     .workOfAdhesion = table.number(row, "work_of_adhesion_j_m2")},
            .cohesiveStress = table.number(row, "sigma0_pa"),
            .filmThickness = numberOr(table, row, "film_thickness_m", 0.0),
            .poissonRatio = numberOr(table, row, "poisson_ratio", kNaN),
            .coneHalfAngle = numberOr(table, row, "cone_half_angle_rad", 0.0),
            .indentation = table.number(row, "indentation_m"),
            .branch = wordIn(table, row, "branch", branchOf(table.text(row, "branch")),
                             keyList<CurveBranch>())};
}

/// The stress of the pair's attraction [Pa]: where the law has no zone of its own, it only says how
/// far the attraction reaches, and may be left open by a stress of 0.
double stressOf(const ContactCase& asked) {
    const bool isZone = traitsOf(asked.law).attraction == Attraction::Zone;
    const bool isStated = isZone ? !hasTail(asked.law) : asked.cohesiveStress > 0.0;
    return isStated ? asked.cohesiveStress : asked.pair.workOfAdhesion / kCohesiveRange;
}

/// The law of a film needs one.
ContactStatus filmStatus(ContactLaw law, const ContactCase& asked) {
    if (isFilm(law) && asked.filmThickness == 0.0) {
        return ContactStatus::FilmThicknessOutOfRange;
    }
    return checkFilm(asked.filmThickness, asked.poissonRatio);
}

/// The law must take a cone into account.
ContactStatus coneStatus(ContactLaw law, double halfAngle) {
    const ContactStatus status = checkCone(halfAngle);
    const bool isLeftOut = halfAngle > 0.0 && leavesOutCone(law);
    return status == ContactStatus::Solved && isLeftOut ? ContactStatus::LawWithoutCone : status;
}

/// Why the law does not hold at a state, the worst reason first, joined by '|'; else "ok".
std::string statusOf(const ContactModel& model, const ContactState& state) {
    const double radius = model.pair().tipRadius;
    const bool isSphereZone = isSphere(model.law()) && model.cohesiveStress() > 0.0;
    const bool isAtEquator =
        isSphereZone && model.coneHalfAngle() == 0.0 && state.cohesiveRadius >= radius;
    std::string status;
    const auto add = [&](bool applies, const char* word) {
        status += applies ? (status.empty() ? "" : "|") + std::string(word) : "";
    };
    add(isAtEquator, "cohesive_zone_at_equator");
    add(!isAtEquator && isBeyondSphere(model, state), "beyond_sphere");
    add(state.contactRadius > model.widestFilmContact(), "thin_film");
    add(!isAtEquator && leavesLawsRange(model, state), "law_out_of_range");
    add(isLargeContact(state.contactRadius, radius), "large_contact");
    return status.empty() ? "ok" : status;
}

ContactAnswer answerTo(const ContactCase& asked) {
    const double stress = stressOf(asked);
    const ContactStatus pairStatus = checkPair(asked.pair, stress);
    if (pairStatus != ContactStatus::Solved) {
        return {keyOf(pairStatus)};
    }
    const ContactStatus sampleStatus = filmStatus(asked.law, asked);
    if (sampleStatus != ContactStatus::Solved) {
        return {keyOf(sampleStatus)};
    }
    const ContactStatus tipStatus = coneStatus(asked.law, asked.coneHalfAngle);
    if (tipStatus != ContactStatus::Solved) {
        return {keyOf(tipStatus)};
    }
    const ContactModel model(asked.law, asked.pair,
                             {.cohesiveStress = stress,
                              .filmThickness = asked.filmThickness,
                              .film = {.poissonRatio = asked.poissonRatio},
                              .coneHalfAngle = asked.coneHalfAngle});
    const ContactMemory memory{asked.branch, 0.0};
    const ContactState state = model.equilibrium(asked.indentation, 0.0, memory);
    if (!state.solved()) {
        return {keyOf(state.status)};
    }
    return {statusOf(model, state), state, model.lambda()};
}

/// A case whose number differs by a factor; the range of adhesion stays.
ContactCase moved(ContactCase asked, double ContactPair::*number, double factor) {
    asked.pair.*number *= factor;
    if (number == &ContactPair::workOfAdhesion) {
        asked.cohesiveStress *= factor;
    }
    return asked;
}

double forceOf(const ContactCase& asked) {
    const ContactAnswer answer = answerTo(asked);
    return answer.state ? answer.state->force : kNaN;
}

/// Half the difference between each number one deviation above and below, by the squares; not a
/// number where one of them has no answer.
ForceDeviation forceDeviation(const ContactCase& asked, const CaseDeviations& deviations) {
    ForceDeviation all;
    double largest = 0.0;
    for (std::size_t i = 0; i < kDeviations.size(); ++i) {
        const double factor = 1.0 + deviations[i];
        const double share =
            0.5 * std::abs(forceOf(moved(asked, kDeviations[i].number, factor)) -
                           forceOf(moved(asked, kDeviations[i].number, 1 / factor)));
        all.sigma = std::hypot(all.sigma, share);
        if (share > largest) {
            largest = share;
            all.by = kDeviations[i].name;
        }
    }
    return all;
}

/// Returns none where the table states none. @throw InputError where one is no share
std::optional<CaseDeviations> readDeviations(const CsvTable& table, std::size_t row) {
    CaseDeviations deviations{};
    bool any = false;
    for (std::size_t i = 0; i < kDeviations.size(); ++i) {
        any = any || table.has(kDeviations[i].column);
        deviations[i] = numberOr(table, row, kDeviations[i].column, 0.0);
        if (!isWithin(deviations[i], 0.0, 1.0)) {
            throw InputError(table.file(), "line " + std::to_string(table.line(row)),
                             std::string(kDeviations[i].column) + " must lie between 0 and 1");
        }
    }
    return any ? std::optional(deviations) : std::nullopt;
}

/// Numbers only where there is a state behind them.
void write(CsvWriter& csv, const ContactAnswer& answer) {
    const auto& state = answer.state;
    csv.add(state ? state->force : kNaN)
        .add(state ? state->contactRadius : kNaN)
        .add(state ? state->cohesiveRadius : kNaN)
        .add(answer.lambda)
        .add(state ? keyOf(state->region()) : "none")
        .add(answer.status);
}

std::vector<std::string> commentsFor(const std::string& cases) {
    return {
        std::string("Asperity ") + kVersion + ": contact at given indentation; cases: " + cases,
        "SI units, as each column's name ends; force > 0 is repulsive, indentation < 0 a gap",
        "state: far, cohesive (zone without contact), contact; lambda: transition parameter, 0 "
        "for laws without a cohesive zone",
        "status: ok; or joined by '|', all evaluated formally: cohesive_zone_at_equator; thin_film "
        "(beyond what the law holds for); law_out_of_range (the law leaves out adhesion, or its "
        "range, that acts here); large_contact (a/R above 0.3: strain beyond linear elasticity, "
        "whichever law); else why there is no answer"};
}

void contact(const CaseFiles& files) {
    requireWritableTable(files.out, {files.cases});
    const CsvTable table =
        readCases(files.cases, {"model", "radius_m", "e_star_pa", "work_of_adhesion_j_m2",
                                "sigma0_pa", "indentation_m", "branch"});
    std::vector<ContactCase> cases;  // all before the first is answered: a table is whole or not
    for (std::size_t row = 0; row < table.rows(); ++row) {
        cases.push_back(readCase(table, row));
    }
    std::vector<std::optional<CaseDeviations>> deviations;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        deviations.push_back(readDeviations(table, row));
    }
    CaseAnswers answers{.comments = commentsFor(files.cases),
                        .columns = {"force_n", "contact_radius_m", "cohesive_radius_m", "lambda",
                                    "state", "status"},
                        .add = [&](CsvWriter& csv, std::size_t row) {
                            write(csv, answerTo(cases[row]));
                            if (deviations[row]) {
                                const ForceDeviation found =
                                    forceDeviation(cases[row], *deviations[row]);
                                csv.add(found.sigma).add(found.by);
                            }
                        }};
    if (!deviations.empty() && deviations.front()) {
        answers.columns.insert(answers.columns.end(), {"force_sigma_n", "force_sigma_by"});
    }
    writeTable(files.out, [&](std::ostream& out, Progress* progress) {
        writeCases(out, table, answers, progress);
    });
}

constexpr const char* kCasesHelp =
    "The cases are a CSV table with the columns\n"
    "  nx,ny,nz                 surface normal out of the sample, of any length\n"
    "  vx,vy,vz                 velocity of the tip relative to the sample [m/s]\n"
    "  alpha_rad,theta_rad      bending and torsion signal, with their standard deviations\n"
    "  sigma_alpha_rad,sigma_theta_rad\n"
    "  friction_coefficient,shear_strength_pa,contact_area_m2\n"
    "  normal_force_model_n,normal_force_sigma_n\n"
    "                           normal force of a contact model, with its standard deviation\n"
    "normal_deviation_rad, which a table need not have, is the standard deviation of the normal's\n"
    "direction about each axis across it; without it the normal counts as exact.\n"
    "With inv_ols_m_v and lateral_sensitivity_rad_v in the probe file, vertical_v,lateral_v,\n"
    "sigma_vertical_v,sigma_lateral_v may replace the four columns in radians.\n"
    "All vectors and the covariance are in the lab frame. Added are fx_n,fy_n,fz_n,cxx_n2,cyy_n2,\n"
    "czz_n2,cxy_n2,cxz_n2,cyz_n2,condition,case; the case is regular, near_singular, no_sliding\n"
    "or invalid_input (a NaN, a normal without direction, a deviation that is not positive: the\n"
    "numbers are then nan), followed by implausibilities: |pushes_along |excess_friction\n"
    "|contradicts_model.";

struct DecoupleOptions {
    std::string probe;
    CaseFiles files;
};

void decouple(const DecoupleOptions& options) {
    requireWritableTable(options.files.out, {options.files.cases, options.probe});
    writeTable(options.files.out, [&](std::ostream& out, Progress* progress) {
        writeForceEstimates(options.probe, options.files.cases, out, progress);
    });
}

}  // namespace

void addContactCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "contact", "Compute force, contact radius and state for each case of a table, at its "
                   "indentation");
    command->footer(
        "Columns of the cases:\nmodel (" + keyList<ContactLaw>() +
        "),\nradius_m, e_star_pa, work_of_adhesion_j_m2, sigma0_pa (of the "
        "md models; of others the reach of adhesion, 0: 0.36 nm), indentation_m (< 0: a "
        "gap),\nbranch (" +
        keyList<CurveBranch>() +
        "). Of a film on a "
        "rigid base, too: film_thickness_m (0: a half-space),\npoisson_ratio (0 to 0.5). Of a tip "
        "whose sphere continues as a cone (sneddon, jkr_sphere, md_sphere, split_sphere), too:\n"
        "cone_half_angle_rad (0: no cone).\nWith relative standard deviations, radius_deviation, "
        "e_star_deviation, work_of_adhesion_deviation\n(0 to 1), force_sigma_n and force_sigma_by "
        "are added: the resulting deviation of the force, and its main source.");
    const auto files = std::make_shared<CaseFiles>();
    addCaseFiles(*command, *files);
    command->callback([files] { contact(*files); });
}

void addDecoupleCommand(CLI::App& program) {
    const auto options = std::make_shared<DecoupleOptions>();
    CLI::App* command = program.add_subcommand(
        "decouple",
        "Compute 3-D forces with covariance from lever signals, for each case of a table");
    command->footer(kCasesHelp);
    command->add_option("--probe", options->probe, "probe file (TOML)")
        ->required()
        ->check(notEmpty());
    addCaseFiles(*command, options->files);
    command->callback([options] { decouple(*options); });
}

}  // namespace asperity
