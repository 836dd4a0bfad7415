#include "core/surface/deformation/SurfaceDeformation.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/deformation/DisplacementField.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/TestTip.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

using test::kTipRadius;

constexpr ScanSize kPatchScan{.columns = 60, .rows = 48, .sizeX = 120.0_nm, .sizeY = 120.0_nm};
constexpr PatchGrid kGrid{.halfWidth = 12.0_nm, .samples = 97};

constexpr std::array kModels{DeformationModel::FourPoint, DeformationModel::ContactRadius,
                             DeformationModel::ClosedForm};

struct ObliqueSlope {
    double slope = 0.0;
    [[nodiscard]] double height(double x, double y) const { return slope * (x - 0.3 * y); }
};

BSplineSurface plane(double slope = 0.0) {
    return fitSurface(sampledMap(kPatchScan, ObliqueSlope{slope}));
}

BSplineSurface eggBox() {
    return fitSurface(sampledMap(
        kPatchScan, EggBox{.amplitude = 5.0_nm, .periodX = 60.0_nm, .periodY = 40.0_nm}));
}

/// The tip pushed into the surface by `indentation` at the closest point below (x, y).
TipContact contactAt(const BSplineSurface& surface, double x, double y, double indentation,
                     double contactRadius) {
    const HeightSample s = surface.at(x, y);
    TipContact contact;
    contact.closest = Vector3(x, y, s.height);
    contact.normal = s.normal();
    contact.tipCenter = contact.closest + (kTipRadius - indentation) * contact.normal;
    contact.tipRadius = kTipRadius;
    contact.contactRadius = contactRadius;
    contact.indentation = indentation;
    return contact;
}

double fromAxis(const TipContact& contact, const Vector3& point) {
    return (point - contact.closest).cross(contact.normal).norm();
}

SurfacePatch patchOf(const BSplineSurface& surface, const TipContact& contact,
                     DeformationModel model) {
    return deformedPatch(surface, contact, kGrid, model, [](double) { return 0.0; });
}

TEST(SurfaceDeformation, RestPointsAreTheSurface) {
    const BSplineSurface surface = eggBox();
    for (const DeformationModel model : kModels) {
        const SurfacePatch patch =
            patchOf(surface, contactAt(surface, 63.0_nm, 58.0_nm, 0.5_nm, 2.0_nm), model);
        ASSERT_EQ(patch.columns, 97);
        ASSERT_EQ(patch.rows, 97);
        ASSERT_EQ(patch.rest.size(), 97U * 97U);
        const Vector3& corner = patch.rest[patch.index(0, 0)];
        EXPECT_NEAR(corner.x(), 51.0_nm, 1e-20);
        EXPECT_NEAR(corner.y(), 46.0_nm, 1e-20);
        EXPECT_NEAR(patch.rest[patch.index(0, 96)].x(), 75.0_nm, 1e-20);
        for (const Vector3& rest : patch.rest) {
            ASSERT_NEAR(rest.z(), surface.at(rest.x(), rest.y()).height, 1e-12 * 5.0_nm);
        }
    }
}

TEST(SurfaceDeformation, WithoutDisplacementNothingMoves) {
    const BSplineSurface surface = eggBox();
    for (const DeformationModel model : kModels) {
        // far from the surface: no contact, and a gap that is no reason to draw the surface up
        const SurfacePatch patch =
            patchOf(surface, contactAt(surface, 63.0_nm, 58.0_nm, -4.0_nm, 0.0), model);
        for (std::size_t i = 0; i < patch.rest.size(); ++i) {
            ASSERT_EQ(patch.rest[i], patch.points[i]);
        }
    }
    const SurfacePatch still = patchOf(surface, contactAt(surface, 63.0_nm, 58.0_nm, 0.0, 2.0_nm),
                                       DeformationModel::FourPoint);
    for (std::size_t i = 0; i < still.rest.size(); ++i) {
        ASSERT_EQ(still.rest[i], still.points[i]);
    }
}

TEST(SurfaceDeformation, NormalsOfAnUndeformedPatchAreThoseOfTheSurface) {
    const BSplineSurface surface = eggBox();
    const SurfacePatch patch = patchOf(surface, contactAt(surface, 63.0_nm, 58.0_nm, 0.0, 0.0),
                                       DeformationModel::ClosedForm);
    for (int row = 1; row < patch.rows - 1; ++row) {
        for (int column = 1; column < patch.columns - 1; ++column) {
            const std::size_t i = patch.index(row, column);
            const Vector3 exact = surface.at(patch.rest[i].x(), patch.rest[i].y()).normal();
            ASSERT_LT((patch.normals[i] - exact).norm(), 1e-3);
        }
    }
}

/// Distances to the tip's surface of the patch's points well inside the contact circle.
void expectOnTip(const SurfacePatch& patch, const TipContact& contact) {
    int inside = 0;
    const double spacing = contact.contactRadius / 8.0;
    // A control net on a sphere holds a surface that lies off it by spacing^2 / (3 R).
    const double resolution = spacing * spacing / (3.0 * kTipRadius) * 1.1;
    for (const Vector3& point : patch.points) {
        if (fromAxis(contact, point) > contact.contactRadius - 2.5 * spacing) {
            continue;
        }
        ++inside;
        ASSERT_NEAR((point - contact.tipCenter).norm(), kTipRadius, resolution);
        ASSERT_LT((point - contact.tipCenter).dot(contact.normal), 0.0);
    }
    EXPECT_GT(inside, 20);
}

TEST(ContactRadiusModel, PressesTheSurfaceOntoTheTip) {
    for (const double slope : {0.0, 0.4, 2.0}) {
        const BSplineSurface surface = plane(slope);
        const TipContact contact = contactAt(surface, 61.3_nm, 57.1_nm, 0.8_nm, 4.0_nm);
        const SurfacePatch patch = patchOf(surface, contact, DeformationModel::ContactRadius);
        expectOnTip(patch, contact);
        const std::size_t middle = patch.index(48, 48);
        EXPECT_NEAR((patch.points[middle] - patch.rest[middle]).dot(contact.normal), -0.8_nm,
                    0.01_nm);
    }
}

TEST(ContactRadiusModel, DrawsANeckUpToTheRetractingTip) {
    for (const double slope : {0.0, 0.4}) {
        const BSplineSurface surface = plane(slope);
        const TipContact contact = contactAt(surface, 61.3_nm, 57.1_nm, -1.2_nm, 3.0_nm);
        const SurfacePatch patch = patchOf(surface, contact, DeformationModel::ContactRadius);
        expectOnTip(patch, contact);
        for (std::size_t i = 0; i < patch.rest.size(); ++i) {
            const double rise = (patch.points[i] - patch.rest[i]).dot(contact.normal);
            ASSERT_GE(rise, -1e-20);  // nothing is pushed in
            if (fromAxis(contact, patch.rest[i]) < 2.0_nm) {
                ASSERT_GT(rise, 1.1_nm);
            }
        }
    }
}

TEST(ContactRadiusModel, LeavesTheSurfaceOutsideTheContactAlone) {
    const BSplineSurface surface = eggBox();
    const TipContact contact = contactAt(surface, 63.0_nm, 58.0_nm, 0.8_nm, 4.0_nm);
    const SurfacePatch patch = patchOf(surface, contact, DeformationModel::ContactRadius);
    for (std::size_t i = 0; i < patch.rest.size(); ++i) {
        if (fromAxis(contact, patch.rest[i]) > 4.0_nm + 3.0 * 0.5_nm) {
            ASSERT_EQ(patch.points[i], patch.rest[i]);
        }
    }
}

TEST(ContactRadiusModel, HasARoundRim) {
    const BSplineSurface surface = plane();
    const double radius = 2.0_nm;
    const TipContact contact = contactAt(surface, 61.3_nm, 58.2_nm, 0.5_nm, radius);
    const DisplacementField field = contactRadiusField(surface, contact);
    for (const double distance : {0.9 * radius, radius, 1.1 * radius}) {
        double deepest = 0.0;
        double shallowest = contact.indentation;
        for (int i = 0; i < 200; ++i) {
            const double angle = 0.01 * std::numbers::pi * i;
            const Vector3 arm(std::cos(angle), std::sin(angle), 0.0);
            const double depth = -field(contact.closest + distance * arm).z();
            deepest = std::max(deepest, depth);
            shallowest = std::min(shallowest, depth);
        }
        EXPECT_LT(deepest - shallowest, 0.1 * contact.indentation) << distance / radius;
    }
}

TEST(ContactRadiusModel, StaysFiniteWhereTheContactIsWiderThanTheTip) {
    const BSplineSurface surface = plane();
    const TipContact contact = contactAt(surface, 60.0_nm, 60.0_nm, 20.0_nm, 30.0_nm);
    const SurfacePatch patch = patchOf(surface, contact, DeformationModel::ContactRadius);
    for (const Vector3& point : patch.points) {
        ASSERT_TRUE(point.allFinite());
    }
    const Vector3& deepest = patch.points[patch.index(48, 48)];
    EXPECT_NEAR(deepest.z(), -20.0_nm, 0.5_nm);
}

TEST(FourPointModel, MovesTheSurfaceAlongTheNormalAroundTheClosestPoint) {
    for (const double indentation : {0.8_nm, -0.5_nm}) {
        const BSplineSurface surface = plane(0.4);
        const TipContact contact = contactAt(surface, 61.3_nm, 57.1_nm, indentation, 2.0_nm);
        const SurfacePatch patch = patchOf(surface, contact, DeformationModel::FourPoint);
        double largest = 0.0;
        for (std::size_t i = 0; i < patch.rest.size(); ++i) {
            const Vector3 move = patch.points[i] - patch.rest[i];
            const double along = -move.dot(contact.normal) / indentation;
            ASSERT_LT(move.cross(contact.normal).norm(), 1e-20);
            ASSERT_GE(along, -1e-12);
            ASSERT_LE(along, 1.0);
            largest = std::max(largest, along);
            if (fromAxis(contact, patch.rest[i]) > 8.0_nm) {
                ASSERT_EQ(along, 0.0);
            }
        }
        // Four equal control points carry between (2/3)^2 and (23/24)^2 of the middle.
        EXPECT_GT(largest, 0.44);
    }
}

TEST(ClosedFormModel, MovesEveryPointByExactlyTheDisplacement) {
    const auto displacement = [](double r) { return 0.7_nm * std::exp(-r / 3.0_nm) - 0.1_nm; };
    for (const double slope : {0.0, 1.5}) {
        const BSplineSurface surface = plane(slope);
        const TipContact contact = contactAt(surface, 61.3_nm, 57.1_nm, 0.6_nm, 2.0_nm);
        const SurfacePatch patch =
            deformedPatch(surface, contact, kGrid, DeformationModel::ClosedForm, displacement);
        for (std::size_t i = 0; i < patch.rest.size(); ++i) {
            const double r = fromAxis(contact, patch.rest[i]);
            const Vector3 expected = -displacement(r) * contact.normal;
            ASSERT_LT((patch.points[i] - patch.rest[i] - expected).norm(), 1e-12 * 5.0_nm);
        }
    }
}

TEST(ClosedFormModel, GivesTheNormalsOfTheDeformedSurface) {
    const double bowl = 30.0_nm;
    const BSplineSurface surface = plane();
    const SurfacePatch patch = deformedPatch(
        surface, contactAt(surface, 60.0_nm, 60.0_nm, 0.6_nm, 2.0_nm), kGrid,
        DeformationModel::ClosedForm, [=](double r) { return -r * r / (2.0 * bowl); });
    const std::size_t i = patch.index(60, 40);
    const Vector3 arm = patch.points[i] - Vector3(60.0_nm, 60.0_nm, 0.0);
    const Vector3 exact = Vector3(-arm.x() / bowl, -arm.y() / bowl, 1.0).normalized();
    EXPECT_LT((patch.normals[i] - exact).norm(), 1e-9);  // differences of a quadratic are exact
}

TEST(SurfaceDeformation, IsCutOffAtTheScansEdge) {
    const BSplineSurface surface = eggBox();
    for (const DeformationModel model : kModels) {
        const SurfacePatch patch =
            patchOf(surface, contactAt(surface, 1.0_nm, 118.0_nm, 0.5_nm, 3.0_nm), model);
        EXPECT_EQ(patch.rest.front().x(), 0.0);
        EXPECT_NEAR(patch.rest.back().y(), 120.0_nm, 1e-20);
        for (const Vector3& normal : patch.normals) {
            ASSERT_NEAR(normal.norm(), 1.0, 1e-12);
        }
    }
}

TEST(SurfaceDeformation, RefusesWhatCannotBeDrawn) {
    const BSplineSurface surface = plane();
    const TipContact good = contactAt(surface, 60.0_nm, 60.0_nm, 0.5_nm, 2.0_nm);
    const auto draw = [&](const TipContact& contact, const PatchGrid& grid) {
        (void)deformedPatch(surface, contact, grid, DeformationModel::ContactRadius);
    };
    TipContact bad = good;
    bad.closest.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(draw(bad, kGrid), Error);
    bad = good;
    bad.contactRadius = -1.0_nm;
    EXPECT_THROW(draw(bad, kGrid), Error);
    EXPECT_THROW(draw(good, {.halfWidth = 0.0, .samples = 10}), Error);
    EXPECT_THROW(draw(good, {.halfWidth = 1.0_nm, .samples = 1}), Error);
    EXPECT_THROW(draw(good, {.halfWidth = 1.0_nm, .samples = kMaxPatchSamples + 1}), Error);
    EXPECT_THROW((void)deformedPatch(surface, good, kGrid, DeformationModel::ClosedForm), Error);
}

}  // namespace
}  // namespace asperity
