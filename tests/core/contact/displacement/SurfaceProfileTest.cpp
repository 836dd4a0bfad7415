#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "core/contact/numerics/GaussLegendre.h"
#include "tests/core/contact/laws/ContactCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity {
namespace {

using std::numbers::pi;
using test::expectClose;
using test::ReferenceTable;

/// The profile that a row of T08 describes.
CohesiveContact profileOf(const ReferenceTable& table, std::size_t row) {
    const std::string& model = table.text(row, "model");
    const bool cohesive = model == "MD";
    const double a = table.number(row, "a_m");
    return {.tipRadius = table.number(row, "R_m"),
            .reducedModulus = table.number(row, "Es_Pa"),
            .cohesiveStress = cohesive ? table.number(row, "s0_Pa") : 0.0,
            .indentation = table.number(row, "delta_m"),
            .contactRadius = a,
            .cohesiveRadius = cohesive ? table.number(row, "c_m") : a,
            .edgeWork = model == "JKR" ? table.number(row, "w") : 0.0};
}

/// Largest displacement of the profile: on the axis, or the lift where the zone ends.
double peakOf(const CohesiveContact& contact) {
    return std::max(std::abs(contact.indentation), 4.0 * contact.cohesiveStress *
                                                       contact.cohesiveRadius /
                                                       (pi * contact.reducedModulus));
}

TEST(SurfaceProfile, HasTheReferenceDisplacementsAndGaps) {
    const ReferenceTable table = test::referenceTable("T08_surface_profiles.csv");
    ASSERT_EQ(table.rows(), 284U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const CohesiveContact contact = profileOf(table, row);
        const double radius = table.number(row, "r_m");
        const double peak = peakOf(contact);
        EXPECT_NEAR(surfaceDisplacement(contact, radius), table.number(row, "u_z_m"), 1e-12 * peak);
        expectClose(surfaceGap(contact, radius), table.number(row, "gap_m"), 1e-12, peak);
    }
}

TEST(SurfaceProfile, HasTheReferencePressures) {
    const ReferenceTable table = test::referenceTable("T08_surface_profiles.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const CohesiveContact contact = profileOf(table, row);
        const double pressure = contactPressure(contact, table.number(row, "r_m"));
        const double expected = table.number(row, "p_Pa");
        if (std::isinf(expected)) {
            EXPECT_TRUE(std::isinf(pressure) && std::signbit(pressure));
            continue;
        }
        const double highest =
            (2.0 * contact.reducedModulus * contact.contactRadius / (pi * contact.tipRadius)) +
            contact.cohesiveStress;
        expectClose(pressure, expected, 1e-12, highest);
    }
}

/// Profile of a state of one of the sphere laws.
CohesiveContact onSphere(const ContactPair& pair, const LawPoint& point) {
    return {.tipRadius = pair.tipRadius,
            .reducedModulus = pair.reducedModulus,
            .indentation = point.indentation,
            .contactRadius = point.contactRadius,
            .cohesiveRadius = point.cohesiveRadius,
            .shape = TipShape::Sphere};
}

/// Sneddon, JKR and cohesive zone on a sphere with contacts from slight to nearly the equator.
std::vector<CohesiveContact> sphereProfiles() {
    std::vector<CohesiveContact> profiles;
    const ContactPair pair{2e-8, 1e9, 1.0};
    const double stress = 4e8;
    for (const double ratio : {1e-3, 0.1, 0.29, 0.31, 0.6, 0.9, 0.97}) {
        const double a = ratio * pair.tipRadius;
        profiles.push_back(onSphere(pair, SneddonLaw(pair).at(a)));
        profiles.push_back(onSphere(pair, SphereJkrLaw(pair).at(a)));
        profiles.back().edgeWork = pair.workOfAdhesion;
        profiles.push_back(onSphere(pair, SphereMaugisLaw(pair, stress).at(a)));
        profiles.back().cohesiveStress = stress;
    }
    return profiles;
}

/// g(t) of docs/theory.md 4.1 over both parts of the contact.
double abelDensity(const CohesiveContact& contact, double t) {
    if (t < contact.contactRadius) {
        return contact.indentation - (t * std::atanh(t / contact.tipRadius));
    }
    const double c = contact.cohesiveRadius;
    return -2.0 * contact.cohesiveStress / contact.reducedModulus *
           std::sqrt(std::max(0.0, (c - t) * (c + t)));
}

/// Integral in panels that narrow towards `high`, where the integrand may be singular.
template <typename Function>
double gradedIntegral(const Function& function, double low, double high) {
    double sum = 0.0;
    double width = high - low;
    for (int i = 0; i < 60; ++i) {
        sum += gaussLegendre(function, high - width, high - (0.5 * width));
        width *= 0.5;
    }
    return sum;
}

/// u(r) of docs/theory.md 4.1 by numerical integration, t = r sin(psi).
double abelDisplacement(const CohesiveContact& contact, double r) {
    const auto integrand = [&](double psi) { return abelDensity(contact, r * std::sin(psi)); };
    const double edge = std::asin(std::min(1.0, contact.contactRadius / r));
    const double end = std::asin(std::min(1.0, contact.cohesiveRadius / r));
    return 2.0 / pi * (gradedIntegral(integrand, 0.0, edge) + gradedIntegral(integrand, edge, end));
}

TEST(SurfaceProfile, IsAbelsTransformForASphere) {
    for (const CohesiveContact& contact : sphereProfiles()) {
        SCOPED_TRACE(contact.contactRadius);
        for (const double position : {0.3, 0.999, 1.001, 1.02, 1.4, 3.0, 30.0, 1e4}) {
            const double r = position * contact.contactRadius;
            SCOPED_TRACE(r / contact.tipRadius);
            const double peak = peakOf(contact);
            EXPECT_NEAR(surfaceDisplacement(contact, r), abelDisplacement(contact, r),
                        1e-10 * peak);
        }
        for (const double position : {0.999999, 1.0, 1.000001}) {
            const double r = position * contact.tipRadius;
            EXPECT_NEAR(surfaceDisplacement(contact, r), abelDisplacement(contact, r),
                        1e-10 * peakOf(contact));
        }
    }
}

TEST(SurfaceProfile, OpensTheGapOfASphereToTheCohesiveRange) {
    const ContactPair pair{2e-8, 1e9, 0.2};
    const double stress = 4e8;
    const SphereMaugisLaw law(pair, stress);
    for (const double ratio : {0.0, 1e-3, 0.2, 0.5, 0.8}) {
        CohesiveContact contact = onSphere(pair, law.at(ratio * pair.tipRadius));
        contact.cohesiveStress = stress;
        SCOPED_TRACE(ratio);
        EXPECT_NEAR(surfaceGap(contact, contact.cohesiveRadius), pair.workOfAdhesion / stress,
                    1e-12 * (peakOf(contact) + pair.tipRadius));
    }
}

/// The pressure carries the force: its integral over the surface. In v = sqrt(a^2 - r^2) the
/// singular edge of JKR is smooth.
TEST(SurfaceProfile, CarriesTheForceOfASphere) {
    constexpr int kPanels = 8;
    const ContactPair pair{2e-8, 1e9, 1.0};
    for (const CohesiveContact& contact : sphereProfiles()) {
        SCOPED_TRACE(contact.contactRadius);
        const double a = contact.contactRadius;
        const double c = contact.cohesiveRadius;
        const auto ring = [&](double v) {
            return 2.0 * pi * v * contactPressure(contact, std::sqrt((a - v) * (a + v)));
        };
        double inContact = 0.0;
        for (int i = 0; i < kPanels; ++i) {
            inContact += gaussLegendre(ring, a * i / kPanels, a * (i + 1) / kPanels);
        }
        const double force = inContact - (pi * contact.cohesiveStress * (c - a) * (c + a));
        const LawPoint point = contact.edgeWork > 0.0 ? SphereJkrLaw(pair).at(a)
                               : contact.cohesiveStress > 0.0
                                   ? SphereMaugisLaw(pair, contact.cohesiveStress).at(a)
                                   : SneddonLaw(pair).at(a);
        const double pulled =
            std::sqrt(8.0 * pi * a * a * a * contact.edgeWork * pair.reducedModulus) +
            (pi * c * c * contact.cohesiveStress);
        expectClose(force, point.force, 1e-9, pulled);
    }
}

/// Contacts of a hundredth of the radius are as good as a paraboloid's.
TEST(SurfaceProfile, OfASmallContactIsTheParaboloids) {
    const ContactPair pair{1e-6, 1e9, 0.0};
    CohesiveContact sphere = onSphere(pair, SneddonLaw(pair).at(1e-8));
    CohesiveContact paraboloid = sphere;
    paraboloid.shape = TipShape::Paraboloid;
    for (const double r : {0.0, 5e-9, 1e-8, 2e-8, 1e-7, 5e-6}) {
        EXPECT_NEAR(surfaceDisplacement(sphere, r), surfaceDisplacement(paraboloid, r),
                    2e-4 * sphere.indentation);
        expectClose(contactPressure(sphere, r), contactPressure(paraboloid, r), 2e-4);
    }
}

TEST(SurfaceProfile, IsFiniteForAnyContactWithASphere) {
    test::checkProperty([] {
        const ContactPair pair{*test::logUniform(1e-10, 1e-3), *test::logUniform(1.0, 1e13),
                               *test::logUniform(1e-9, 100.0)};
        const double stress = pair.workOfAdhesion / *test::logUniform(1e-11, 1e-8);
        const SphereMaugisLaw law(pair, stress);
        const auto point = law.stable(10.0 * pair.tipRadius * *test::fraction(), 0.0);
        RC_ASSERT(point);
        CohesiveContact contact = onSphere(pair, *point);
        contact.cohesiveStress = stress;
        const double r = contact.cohesiveRadius * *test::logUniform(1e-3, 1e3);
        for (const double position : {r, contact.contactRadius, contact.cohesiveRadius}) {
            RC_ASSERT(std::isfinite(surfaceDisplacement(contact, position)));
            RC_ASSERT(std::isfinite(contactPressure(contact, position)));
            RC_ASSERT(std::abs(surfaceDisplacement(contact, position)) <=
                      (1.0 + 1e-9) * std::max(2.0 * peakOf(contact), 1e-300));
        }
    });
}

/// Beyond the joint of a cone: the pressure bears the force, the surface leaves the tip at the
/// contact's edge without a step, and far away it is that of a point force.
TEST(SurfaceProfile, IsThatOfACone) {
    constexpr double kHalfAngle = 0.35;
    for (const double a : {0.5, 0.95, 1.5, 6.0}) {
        const LawPoint point = SneddonLaw({1.0, 1.0, 0.0}, kHalfAngle).at(a);
        const CohesiveContact contact{.tipRadius = 1.0,
                                      .reducedModulus = 1.0,
                                      .indentation = point.indentation,
                                      .contactRadius = a,
                                      .cohesiveRadius = a,
                                      .shape = TipShape::Sphere,
                                      .coneHalfAngle = kHalfAngle};
        SCOPED_TRACE(a);
        const double joint = std::cos(kHalfAngle);
        const auto load = [&](double from, double to) {
            constexpr int kPieces = 200;
            double sum = 0.0;
            for (int i = 0; i < kPieces; ++i) {
                sum += gaussLegendre(
                    [&](double y) {  // r = a (1 - y^2): the pressure ends as a root
                        const double r = a * (1.0 - (y * y));
                        return 2.0 * pi * r * contactPressure(contact, r) * 2.0 * a * y;
                    },
                    from + ((to - from) * i / kPieces), from + ((to - from) * (i + 1) / kPieces));
            }
            return sum;
        };
        const double turn = a > joint ? std::sqrt(1.0 - (joint / a)) : 0.0;
        expectClose(load(0.0, turn) + load(turn, 1.0), point.force, 1e-5);
        const double inside = surfaceDisplacement(contact, a);
        EXPECT_NEAR(surfaceDisplacement(contact, std::nextafter(a, 9.0)), inside, 1e-6);
        const double far = 500.0;
        expectClose(surfaceDisplacement(contact, far), point.force / pi / far, 1e-3);
        EXPECT_GT(surfaceGap(contact, 1.01 * a), 0.0);
    }
}

}  // namespace
}  // namespace asperity
