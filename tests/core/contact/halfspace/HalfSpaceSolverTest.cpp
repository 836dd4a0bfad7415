#include "core/contact/halfspace/HalfSpaceSolver.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/contact/laws/HertzLaw.h"
#include "tests/core/contact/halfspace/HalfSpaceCases.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;
using test::displacementAt;
using test::elasticContact;
using test::paperPair;
using test::paraboloidContact;
using test::PixelGrid;

ContactModel hertzModel() {
    ContactPair pair = paperPair("PS");
    pair.workOfAdhesion = 0.0;
    return {ContactLaw::Hertz, pair};
}

TEST(HalfSpaceSolver, HasHertzForceAndContactRadius) {
    const ContactModel model = hertzModel();
    for (const double indentation : {0.05_nm, 0.6_nm}) {
        const ContactState hertz = model.equilibrium(indentation, 0.0, {});
        const PixelGrid grid{.samples = 128, .halfWidth = 3.0 * hertz.contactRadius};
        HalfSpaceContact contact = paraboloidContact(grid, model);
        contact.approach = indentation;
        const HalfSpaceSolution solution = HalfSpaceSolver().solve(contact);
        EXPECT_EQ(solution.status, HalfSpaceStatus::Converged);
        EXPECT_FALSE(solution.doubts.any());
        EXPECT_NEAR(solution.force, hertz.force, 1e-3 * hertz.force);
        EXPECT_NEAR(solution.contactRadius, hertz.contactRadius, 0.5 * contact.pitch);
        EXPECT_EQ(solution.cohesiveRadius, solution.contactRadius);
    }
}

/// What a rim that lies a tenth of a pixel beside its position does to the displacement: the grid's
/// resolution [m].
double resolution(const HalfSpaceContact& contact, double rim) {
    return 0.1 * contact.pitch * rim / contact.tipRadius;
}

/// The rows of T08 of a material under no load.
std::vector<std::size_t> unloadedRows(const test::ReferenceTable& table,
                                      const std::string& material) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "model") == "MD" && table.text(row, "material") == material &&
            table.text(row, "state") == "P0") {
            rows.push_back(row);
        }
    }
    return rows;
}

TEST(HalfSpaceSolver, HasTheReferenceDisplacementInsideAndOutsideOfTheContact) {
    const test::ReferenceTable table = test::referenceTable("T08_surface_profiles.csv");
    for (const char* material : {"PS", "SiO2"}) {
        const std::vector<std::size_t> rows = unloadedRows(table, material);
        ASSERT_EQ(rows.size(), 23U);
        const auto value = [&](const char* column) { return table.number(rows.front(), column); };
        const double zone = value("c_m");
        const PixelGrid grid{.samples = 255, .halfWidth = 2.5 * zone};
        HalfSpaceContact contact =
            paraboloidContact(grid, {ContactLaw::Maugis,
                                     {value("R_m"), value("Es_Pa"), value("w")},
                                     {.cohesiveStress = value("s0_Pa")}});
        contact.approach = value("delta_m");
        const HalfSpaceSolution solution = HalfSpaceSolver({.tolerance = 1e-4}).solve(contact);
        for (const std::size_t row : rows) {
            const double radius = table.number(row, "r_m");
            if (radius < 0.95 * grid.halfWidth) {
                EXPECT_NEAR(displacementAt(solution, grid, radius), table.number(row, "u_z_m"),
                            resolution(contact, zone))
                    << material << " at " << radius;
            }
        }
    }
}

TEST(HalfSpaceSolver, HasTheHertzianDisplacementInsideAndOutsideOfTheContact) {
    const ContactModel model = hertzModel();
    const ContactState hertz = model.equilibrium(0.6_nm, 0.0, {});
    const double a = hertz.contactRadius;
    const PixelGrid grid{.samples = 127, .halfWidth = 3.0 * a};
    HalfSpaceContact contact = paraboloidContact(grid, model);
    contact.approach = 0.6_nm;
    const HalfSpaceSolution solution = HalfSpaceSolver().solve(contact);
    for (const double ratio : {0.0, 0.5, 0.9, 1.0, 1.1, 1.5, 2.0, 2.8}) {
        const double r = ratio * a;
        const double exact =
            ratio <= 1.0
                ? contact.approach - r * r / (2.0 * model.pair().tipRadius)
                : ((2.0 * a * a - r * r) * std::asin(a / r) + a * std::sqrt(r * r - a * a)) /
                      (pi * model.pair().tipRadius);
        const bool atTheRim = ratio > 0.8 && ratio < 1.2;
        EXPECT_NEAR(displacementAt(solution, grid, r), exact,
                    atTheRim ? resolution(contact, a) : 1e-3 * contact.approach)
            << ratio;
    }
}

/// Hertz's ellipse from its axes. Source: Johnson, Contact Mechanics (1985), (4.26).
struct HertzEllipse {
    double alongA = 0.0;       ///< half the gap's curvature along the long axis [1/m]
    double alongB = 0.0;       ///< and along the short one [1/m]
    double indentation = 0.0;  ///< [m]
    double force = 0.0;        ///< [N]
};

/// @param a long half axis [m]  @param b short one [m]  @param strain largest pressure over E*
HertzEllipse hertzEllipse(double a, double b, double strain, double modulus) {
    const double e2 = 1.0 - (b * b) / (a * a);
    const double k = std::comp_ellint_1(std::sqrt(e2));
    const double e = std::comp_ellint_2(std::sqrt(e2));
    const double scale = strain * b;
    return {.alongA = scale / (e2 * a * a) * (k - e),
            .alongB = scale / (e2 * a * a) * (a * a / (b * b) * e - k),
            .indentation = scale * k,
            .force = 2.0 / 3.0 * pi * strain * modulus * a * b};
}

TEST(HalfSpaceSolver, HasHertzEllipseWhereTheSampleIsCurvedOneWayMore) {
    const ContactPair pair = hertzModel().pair();
    const double longAxis = 4.0_nm;
    const double shortAxis = 2.0_nm;
    const HertzEllipse ellipse = hertzEllipse(longAxis, shortAxis, 0.04, pair.reducedModulus);
    const PixelGrid grid{.samples = 128, .halfWidth = 6.0_nm};
    HalfSpaceContact contact = elasticContact(grid, pair, [&](double x, double y) {
        return ellipse.alongA * x * x + ellipse.alongB * y * y;
    });
    contact.approach = ellipse.indentation;
    const HalfSpaceSolution solution = HalfSpaceSolver().solve(contact);
    EXPECT_NEAR(solution.force, ellipse.force, 2e-3 * ellipse.force);
    EXPECT_NEAR(solution.contactRadius, std::sqrt(longAxis * shortAxis), 0.5 * contact.pitch);
}

/// Two bumps far from each other each sink into the hollow of the other one.
TEST(HalfSpaceSolver, SumsTwoAsperitiesThatFeelEachOther) {
    const ContactPair pair = hertzModel().pair();
    const double away = 12.0_nm;
    const PixelGrid grid{.samples = 256, .halfWidth = 12.0_nm};
    HalfSpaceContact contact = elasticContact(grid, pair, [&](double x, double y) {
        const double arm = std::abs(x) - 0.5 * away;
        return (arm * arm + y * y) / (2.0 * pair.tipRadius);
    });
    contact.approach = 0.4_nm;
    const HalfSpaceSolution solution = HalfSpaceSolver().solve(contact);
    const ContactModel one(ContactLaw::Hertz, pair);
    double force = 0.0;
    for (int i = 0; i < 50; ++i) {
        const double hollow = force / (pi * pair.reducedModulus * away);
        force = one.equilibrium(contact.approach - hollow, 0.0, {}).force;
    }
    EXPECT_NEAR(solution.force, 2.0 * force, 0.01 * solution.force);
    EXPECT_LT(solution.force, 1.9 * one.equilibrium(contact.approach, 0.0, {}).force);
}

/// The largest pull on the way out in steps of a hundredth of a nanometer, each from the last [N].
double pullOffForce(const ContactModel& model, PixelGrid grid) {
    HalfSpaceContact contact = paraboloidContact(grid, model);
    HalfSpaceSolver solver;
    SurfaceTraction traction;
    double lowest = 0.0;
    for (int step = 0; step < 70; ++step) {
        contact.approach = 0.1_nm - step * 0.01_nm;
        const HalfSpaceSolution solution = solver.solve(contact, traction);
        EXPECT_EQ(solution.status, HalfSpaceStatus::Converged);
        traction = solution.traction;
        lowest = std::min(lowest, solution.force);
    }
    return lowest;
}

TEST(HalfSpaceSolver, HasThePullOffForceOfMaugisAndDugdale) {
    const ContactPair pair = paperPair("PS");
    const double unit = pi * pair.workOfAdhesion * pair.tipRadius;
    // Dimensionless pull-off forces of T02.
    const ContactModel stiff(ContactLaw::Maugis, pair,
                             {.cohesiveStress = pair.workOfAdhesion / 0.5137_nm});
    ASSERT_NEAR(stiff.lambda(), 0.5, 1e-3);
    EXPECT_NEAR(pullOffForce(stiff, {.samples = 128, .halfWidth = 7.0_nm}), -1.7182 * unit,
                0.01 * 1.7182 * unit);
    const ContactModel soft(ContactLaw::Maugis, pair,
                            {.cohesiveStress = pair.workOfAdhesion / 0.1712_nm});
    ASSERT_NEAR(soft.lambda(), 1.5, 1e-3);
    const ContactState last = soft.lastBonded(1.0 / 1e-3);
    EXPECT_NEAR(pullOffForce(soft, {.samples = 128, .halfWidth = 6.0_nm}), last.force,
                -0.01 * last.force);
}

TEST(HalfSpaceSolver, StaysBondedWhereItComesFromContactAndFreeWhereItDoesNot) {
    const ContactModel model(ContactLaw::Maugis, paperPair("PS"));
    HalfSpaceContact contact = paraboloidContact({.samples = 96, .halfWidth = 9.0_nm}, model);
    HalfSpaceSolver solver;
    contact.approach = 0.1_nm;
    SurfaceTraction traction = solver.solve(contact).traction;
    for (int step = 1; step <= 25; ++step) {
        contact.approach = 0.1_nm - step * 0.02_nm;
        traction = solver.solve(contact, traction).traction;
    }
    ASSERT_LT(contact.approach, -contact.cohesiveRange) << "beyond the reach of separate bodies";
    const double bonded = solver.solve(contact, traction).force;
    const double expected = model.equilibrium(contact.approach, 0.0, {ContactBranch::Bonded}).force;
    EXPECT_NEAR(bonded, expected, 0.03 * std::abs(expected));
    EXPECT_EQ(solver.solve(contact).force, 0.0);
}

TEST(HalfSpaceSolver, FindsTheSameStateWarmAsCold) {
    const ContactModel model(ContactLaw::Maugis, paperPair("PS"));
    HalfSpaceContact contact = paraboloidContact({.samples = 128, .halfWidth = 10.0_nm}, model);
    HalfSpaceSolver solver;
    contact.approach = 0.2_nm;
    const HalfSpaceSolution before = solver.solve(contact);
    contact.approach = 0.25_nm;
    const HalfSpaceSolution warm = solver.solve(contact, before.traction);
    const HalfSpaceSolution cold = HalfSpaceSolver().solve(contact);
    const double unit = pi * model.pair().workOfAdhesion * model.pair().tipRadius;
    EXPECT_NEAR(warm.force, cold.force, 3e-3 * unit);
    EXPECT_NEAR(warm.contactRadius, cold.contactRadius, 0.5 * contact.pitch);
    EXPECT_LT(warm.iterations, cold.iterations);
}

TEST(HalfSpaceSolver, FindsContactAnywhereInTheGrid) {
    const ContactPair pair = hertzModel().pair();
    const auto forceAt = [&](double x, double y) {
        const PixelGrid grid{.samples = 100, .halfWidth = 10.0_nm};
        HalfSpaceContact contact = elasticContact(grid, pair, [&](double px, double py) {
            return (std::pow(px - x, 2) + std::pow(py - y, 2)) / (2.0 * pair.tipRadius);
        });
        contact.approach = 0.4_nm;
        return HalfSpaceSolver().solve(contact);
    };
    const HalfSpaceSolution middle = forceAt(0.0, 0.0);
    const HalfSpaceSolution corner = forceAt(7.0_nm, -7.0_nm);
    EXPECT_NEAR(corner.force, middle.force, 2e-3 * middle.force);
    EXPECT_TRUE(corner.valid());
    const HalfSpaceSolution cut = forceAt(9.0_nm, 0.0);
    EXPECT_TRUE(cut.doubts.reachesBorder);
    EXPECT_FALSE(cut.valid());
}

TEST(HalfSpaceSolver, DoubtsLargeAndCoarseContacts) {
    const ContactModel model = hertzModel();
    const double radius = model.pair().tipRadius;
    HalfSpaceContact large = paraboloidContact({.samples = 64, .halfWidth = radius}, model);
    large.approach = 0.35 * 0.35 * radius;
    EXPECT_TRUE(HalfSpaceSolver().solve(large).doubts.largeContact);
    large.approach = 0.25 * 0.25 * radius;
    EXPECT_FALSE(HalfSpaceSolver().solve(large).doubts.largeContact);
    HalfSpaceContact coarse = paraboloidContact({.samples = 16, .halfWidth = radius}, model);
    coarse.approach = 0.2 * 0.2 * radius;
    EXPECT_TRUE(HalfSpaceSolver().solve(coarse).doubts.tooCoarse);
}

TEST(HalfSpaceSolver, StopsWhenAsked) {
    const ContactModel model = hertzModel();
    HalfSpaceContact contact = paraboloidContact({.samples = 64, .halfWidth = 9.0_nm}, model);
    contact.approach = 0.6_nm;
    std::stop_source source;
    source.request_stop();
    const HalfSpaceSolution solution = HalfSpaceSolver().solve(contact, {}, source.get_token());
    EXPECT_EQ(solution.status, HalfSpaceStatus::Canceled);
    EXPECT_LE(solution.iterations, 1);
    EXPECT_FALSE(solution.valid());
    const HalfSpaceSolution bounded = HalfSpaceSolver({.iterations = 2}).solve(contact);
    EXPECT_EQ(bounded.status, HalfSpaceStatus::NotConverged);
}

TEST(HalfSpaceSolver, LeavesSeparateBodiesAlone) {
    HalfSpaceContact contact =
        paraboloidContact({.samples = 32, .halfWidth = 9.0_nm}, hertzModel());
    contact.approach = -0.1_nm;
    const HalfSpaceSolution solution = HalfSpaceSolver().solve(contact);
    EXPECT_TRUE(solution.valid());
    EXPECT_EQ(solution.force, 0.0);
    EXPECT_EQ(*std::max_element(solution.displacement.begin(), solution.displacement.end()), 0.0);
}

TEST(HalfSpaceSolver, RefusesWhatIsNoContact) {
    const HalfSpaceContact good =
        paraboloidContact({.samples = 8, .halfWidth = 9.0_nm}, hertzModel());
    HalfSpaceSolver solver;
    EXPECT_NO_THROW((void)solver.solve(good));
    HalfSpaceContact bad = good;
    bad.gap.pop_back();
    EXPECT_THROW((void)solver.solve(bad), Error);
    bad = good;
    bad.pitch = 0.0;
    EXPECT_THROW((void)solver.solve(bad), Error);
    EXPECT_THROW((void)solver.solve({}), Error);
    EXPECT_THROW((void)solver.solve(good, {.contact = {1.0}, .cohesion = {0.0}}), Error);
}

}  // namespace
}  // namespace asperity
