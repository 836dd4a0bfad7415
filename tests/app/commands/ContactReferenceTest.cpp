#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/io/TextValue.h"
#include "tests/app/commands/CaseRuns.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace asperity {
namespace {

using test::ContactRow;
using test::ReferenceTable;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNearFold = 1e-7;

/// Expected values of a row.
struct Expected {
    double force = 0.0;
    double contactRadius = 0.0;
    double cohesiveRadius = 0.0;
    std::string state;
    double tolerance = 1e-12;
    double forceUnit = 0.0;  ///< near a zero of the force
    bool atFold = false;     ///< the last stable state: rounding of the indentation may pass it
};

/// Cases with what is expected of them. Each goes through the program at its indentation and at
/// ones deeper by some roundings, which gives the condition of the row. Four roundings of work of
/// adhesion, modulus and radius shift the Maugis unit of indentation more than four of the
/// indentation: eight of it are less than all of them together.
class ReferenceCases {
public:
    void add(ContactRow row, const Expected& expected) {
        const double rounding = kEpsilon * std::abs(row.indentation);
        const double indentation = row.indentation;
        for (const double nudge : {0.0, 8.0, 64.0}) {
            row.indentation = indentation + nudge * rounding;
            lines_ += lineOf(row);
        }
        expected_.push_back(expected);
    }

    void check() const {
        const CsvTable out = test::contactTable(lines_);
        ASSERT_EQ(out.rows(), 3 * expected_.size());
        for (std::size_t i = 0; i < expected_.size(); ++i) {
            SCOPED_TRACE("case " + std::to_string(i));
            checkCase(out, 3 * i, expected_[i]);
        }
    }

    [[nodiscard]] std::size_t size() const { return expected_.size(); }

private:
    static void checkCase(const CsvTable& out, std::size_t row, const Expected& expected) {
        const bool passed = expected.atFold && out.text(row, "state") == "far";
        const std::size_t at = passed ? row + 1 : row;
        // At a fold the state varies as the root of the indentation.
        const std::size_t deeper = expected.atFold ? row + 2 : row + 1;
        EXPECT_EQ(out.text(at, "state"), expected.state);
        const auto expectNear = [&](const char* column, double value, double unit) {
            const double limit = std::abs(out.number(deeper, column) - out.number(at, column));
            const double stated = expected.atFold ? kNearFold : expected.tolerance;
            EXPECT_NEAR(out.number(at, column), value,
                        std::max(stated * std::max(std::abs(value), unit), limit))
                << column;
        };
        expectNear("force_n", expected.force, expected.forceUnit);
        expectNear("contact_radius_m", expected.contactRadius, 0.0);
        expectNear("cohesive_radius_m", expected.cohesiveRadius, 0.0);
    }

    std::string lines_;
    std::vector<Expected> expected_;
};

double forceUnit(const ReferenceTable& table, std::size_t row, const char* work,
                 const char* radius) {
    return std::numbers::pi * table.number(row, work) * table.number(row, radius);
}

std::string stateOf(const std::string& kind) {
    return kind == "noncontact" ? "cohesive" : (kind == "free" ? "far" : kind);
}

ContactRow rowOf(const std::string& model, const ReferenceTable& parameters, std::size_t row) {
    return {model, parameters.text(row, "R"), parameters.text(row, "Es"), parameters.text(row, "w"),
            parameters.text(row, "s0")};
}

TEST(ContactReference, HoldsOverExtremeMaterials) {
    const ReferenceTable table = test::referenceTable("T12_extremes.csv");
    ReferenceCases cases;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool adhesive = table.number(row, "w") > 0.0;
        cases.add({adhesive ? "md" : "hertz", table.text(row, "R_m"), table.text(row, "Es_Pa"),
                   table.text(row, "w"), table.text(row, "s0_Pa"), table.number(row, "delta_m")},
                  {.force = table.number(row, "P_N"),
                   .contactRadius = table.number(row, "a_m"),
                   .cohesiveRadius = table.number(row, "c_m"),
                   .state = stateOf(table.text(row, "kind")),
                   .forceUnit = forceUnit(table, row, "w", "R_m"),
                   .atFold = table.text(row, "state") == "jumpoff_disp"});
    }
    EXPECT_EQ(cases.size(), 1120U);
    cases.check();
}

TEST(ContactReference, HasTheTransitionParameterOfEveryCohesiveLaw) {
    const ReferenceTable parameters = test::referenceTable("T16_parameters.csv");
    std::string lines;
    for (std::size_t row = 0; row < parameters.rows(); ++row) {
        for (const std::string model : {"md", "md_sphere", "jkr"}) {
            lines += lineOf(rowOf(model, parameters, row));
        }
    }
    const CsvTable out = test::contactTable(lines);
    ASSERT_EQ(out.rows(), 3 * parameters.rows());
    for (std::size_t row = 0; row < parameters.rows(); ++row) {
        const double lambda = parameters.number(row, "lambda");
        EXPECT_NEAR(out.number(3 * row, "lambda"), lambda, 1e-13 * lambda);
        EXPECT_NEAR(out.number(3 * row + 1, "lambda"), lambda, 1e-13 * lambda);
        EXPECT_EQ(out.number(3 * row + 2, "lambda"), 0.0);
    }
}

/// A tip of 1 m with K = 1 GPa and pi w = 1 J/m^2 has the Maugis units 1 N, 1 mm and 1 um.
TEST(ContactReference, HasTheClassicLawsAtGivenIndentation) {
    const ReferenceTable table = test::referenceTable("T05c_classic_by_delta.csv");
    const std::string work = "0.31830988618379067";
    ReferenceCases cases;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const auto& [model, column] :
             {std::pair{"hertz", "hertz"}, std::pair{"dmt", "dmt"}, std::pair{"jkr", "jkr_s"}}) {
            const double force = table.number(row, std::string(column) + "_P");
            if (std::isnan(force)) {
                continue;
            }
            const double radius = table.number(row, std::string(column) + "_a");
            const double indentation = table.number(row, "delta_bar");
            const bool jkr = column == std::string("jkr_s");
            cases.add({model, "1", "0.75e9", work, "0", 1e-6 * indentation},
                      {.force = force,
                       .contactRadius = 1e-3 * radius,
                       .cohesiveRadius = 1e-3 * radius,
                       .state = "contact",
                       .forceUnit = 1.0,
                       .atFold = jkr && indentation < -0.9085});
        }
    }
    EXPECT_EQ(cases.size(), 30U);
    cases.check();
}

/// The row of T16 for a material and a cohesive stress.
std::size_t parametersOf(const ReferenceTable& parameters, const std::string& material,
                         const std::string& tag) {
    for (std::size_t row = 0; row < parameters.rows(); ++row) {
        if (parameters.text(row, "material") == material && parameters.text(row, "tag") == tag) {
            return row;
        }
    }
    ADD_FAILURE() << "no " << material << " " << tag;
    return 0;
}

TEST(ContactReference, FollowsMaugisDugdaleInAndOut) {
    const ReferenceTable table = test::referenceTable("T06_md_dimensional_curves.csv");
    const ReferenceTable parameters = test::referenceTable("T16_parameters.csv");
    ReferenceCases cases;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::size_t pair =
            parametersOf(parameters, table.text(row, "material"), table.text(row, "tag"));
        ContactRow asked = rowOf("md", parameters, pair);
        asked.indentation = table.number(row, "delta_m");
        asked.branch = table.text(row, "direction");
        cases.add(asked, {.force = table.number(row, "P_N"),
                          .contactRadius = table.number(row, "a_m"),
                          .cohesiveRadius = table.number(row, "c_m"),
                          .state = stateOf(table.text(row, "kind")),
                          .forceUnit = forceUnit(parameters, pair, "w", "R")});
    }
    EXPECT_EQ(cases.size(), 396U);
    cases.check();
}

/// The cohesive stress of the case is not read.
TEST(ContactReference, FollowsTheSplitLaw) {
    const ReferenceTable table = test::referenceTable("T07_split_curve.csv");
    const ReferenceTable parameters = test::referenceTable("T16_parameters.csv");
    ReferenceCases cases;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.number(row, "stable_disp") == 0.0) {
            continue;
        }
        const std::size_t pair = parametersOf(parameters, table.text(row, "material"), "H357");
        const bool tail = table.text(row, "region") == "tail";
        ContactRow asked = rowOf("split", parameters, pair);
        asked.stress = "12345";
        asked.indentation = table.number(row, "delta_m");
        asked.branch = tail ? "approach" : "retract";
        cases.add(asked, {.force = table.number(row, "P_N"),
                          .contactRadius = table.number(row, "a_m"),
                          .cohesiveRadius = table.number(row, "c_m"),
                          .state = tail ? "far" : table.text(row, "region"),
                          .tolerance = 1e-10,
                          .forceUnit = tail ? 0.0 : forceUnit(parameters, pair, "w", "R")});
    }
    EXPECT_EQ(cases.size(), 114U);
    cases.check();
}

/// Row of the least indentation among those of one material: beyond it, to larger contacts, the
/// states are stable.
std::size_t turnOf(const ReferenceTable& table, std::size_t row, const std::string& column) {
    std::size_t turn = row;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        if (table.text(i, "material") == table.text(row, "material") &&
            table.number(i, column) < table.number(turn, column)) {
            turn = i;
        }
    }
    return turn;
}

TEST(ContactReference, HasTheExactSphereWhereItIsStable) {
    const ReferenceTable table = test::referenceTable("T13_sphere_exact.csv");
    ReferenceCases cases;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (const auto& [model, prefix] :
             {std::pair{"sneddon", "sn"}, std::pair{"jkr_sphere", "jkr"},
              std::pair{"md_sphere", "md"}}) {
            const std::string name = prefix;
            const double a = table.number(row, "a_m");
            const std::size_t turn = turnOf(table, row, name + "_delta_m");
            if (name != "sn" && a <= table.number(turn, "a_m")) {
                continue;
            }
            cases.add({model, table.text(row, "R_m"), table.text(row, "Es_Pa"),
                       table.text(row, "w"), table.text(row, "s0_Pa"),
                       table.number(row, name + "_delta_m")},
                      {.force = table.number(row, name + "_P_N"),
                       .contactRadius = a,
                       .cohesiveRadius = name == "md" ? table.number(row, "md_c_m") : a,
                       .state = "contact",
                       .tolerance = 1e-11,
                       .forceUnit = name == "sn" ? 0.0 : forceUnit(table, row, "w", "R_m")});
        }
    }
    EXPECT_GT(cases.size(), 70U);
    cases.check();
}

/// Lengths in film thicknesses of 1 um; a tip of 1 m, so that no contact is large.
TEST(ContactReference, HasTheFilmExactly) {
    const ReferenceTable table = test::referenceTable("T22_film_exact.csv");
    constexpr double kThickness = 1e-6;
    std::string lines;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const double root = table.number(row, "chi") * kThickness;
        lines += "hertz_film,1,1e9,0,0," + exactText(root * root) + ",retract," +
                 exactText(kThickness) + "," + table.text(row, "nu") + "\n";
    }
    const CsvTable out = test::contactTable(lines, test::kFilmHeader);
    ASSERT_EQ(out.rows(), 65U);
    for (std::size_t row = 0; row < out.rows(); ++row) {
        SCOPED_TRACE(row);
        const double root = table.number(row, "chi") * kThickness;
        const double force =
            table.number(row, "force_factor") * 4.0 / 3.0 * 1e9 * root * root * root;
        EXPECT_NEAR(out.number(row, "force_n"), force, 1e-9 * force);
        const double radius = table.number(row, "radius_factor") * root;
        EXPECT_NEAR(out.number(row, "contact_radius_m"), radius, 1e-9 * radius);
        EXPECT_EQ(out.text(row, "state"), "contact");
        const bool atEnd = table.number(row, "a_over_t") == 2.0;  // rounding decides
        EXPECT_TRUE(out.text(row, "status") == "ok" || atEnd);
    }
}

}  // namespace
}  // namespace asperity
