#include "core/Units.h"
#include "tests/vtkplugins/Fakes.h"
#include "vtkplugins/module/vtkAspForceGlyphSource.h"
#include "vtkplugins/module/vtkAspPatchSource.h"
#include "vtkplugins/module/vtkAspSurfaceSource.h"
#include "vtkplugins/module/vtkAspTipSource.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {

namespace {

Vector3 pointOf(vtkPolyData* data, vtkIdType id) { return Vector3(data->GetPoint(id)); }

Vector3 normalOf(vtkPolyData* data, vtkIdType id) {
    return Vector3(data->GetPointData()->GetNormals()->GetTuple(id));
}

double scalarOf(vtkPolyData* data, const char* name, vtkIdType id) {
    return data->GetPointData()->GetArray(name)->GetTuple1(id);
}

/// Every triangle's corners run counter-clockwise about the normals at its corners.
void expectFrontsAlongNormals(vtkPolyData* data) {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(data);
    triangles->Update();
    vtkPolyData* mesh = triangles->GetOutput();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
        vtkNew<vtkIdList> ids;
        mesh->GetCellPoints(cell, ids);
        const Vector3 a = pointOf(mesh, ids->GetId(0));
        const Vector3 ab = (pointOf(mesh, ids->GetId(1)) - a).stableNormalized();
        const Vector3 ac = (pointOf(mesh, ids->GetId(2)) - a).stableNormalized();
        const Vector3 sum = normalOf(mesh, ids->GetId(0)) + normalOf(mesh, ids->GetId(1)) +
                            normalOf(mesh, ids->GetId(2));
        EXPECT_GE(ab.cross(ac).dot(sum), -1e-6) << "triangle " << cell;
    }
}

double areaOf(vtkPolyData* data) {
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(data);
    triangles->Update();
    vtkPolyData* mesh = triangles->GetOutput();
    double area = 0.0;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
        vtkNew<vtkIdList> ids;
        mesh->GetCellPoints(cell, ids);
        const Vector3 a = pointOf(mesh, ids->GetId(0));
        area +=
            0.5 * (pointOf(mesh, ids->GetId(1)) - a).cross(pointOf(mesh, ids->GetId(2)) - a).norm();
    }
    return area;
}

}  // namespace

TEST(SurfaceSource, SamplesAParaboloidWithItsAnalyticNormals) {
    // A cubic B-spline whose control heights are k x^2 is k (x^2 + h^2 / 3) everywhere.
    constexpr double kCurvature = 2.0e6;
    constexpr double kPitch = 10.0_nm;
    const BSplineSurface surface =
        test::splineOf(64, kPitch, [](double x, double) { return kCurvature * x * x; });
    vtkNew<vtkAspSurfaceSource> source;
    source->SetSurface(&surface);
    source->SetWindow(100.0_nm, 400.0_nm, 200.0_nm, 500.0_nm);
    source->SetResolution(31, 16);
    source->Update();
    vtkPolyData* output = source->GetOutput();
    ASSERT_EQ(output->GetNumberOfPoints(), 31 * 16);
    EXPECT_EQ(output->GetNumberOfStrips(), 15);
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id) {
        const double x = 100.0_nm + static_cast<int>(id % 31) * 10.0_nm;
        const double y = 200.0_nm + static_cast<int>(id / 31) * 20.0_nm;
        const double z = kCurvature * (x * x + kPitch * kPitch / 3.0);
        EXPECT_LT((pointOf(output, id) - Vector3(x, y, z)).norm(), 1e-6 * x);
        EXPECT_NEAR(scalarOf(output, "height", id), z, 1e-6 * z);
        const Vector3 expected = Vector3(-2.0 * kCurvature * x, 0.0, 1.0).normalized();
        EXPECT_LT((normalOf(output, id) - expected).norm(), 1e-6);
    }
    expectFrontsAlongNormals(output);
}

TEST(SurfaceSource, LeavesAHoleOpenExactlyWhereItIsAsked) {
    const BSplineSurface surface = test::splineOf(64, 10.0_nm, [](double, double) { return 0.0; });
    vtkNew<vtkAspSurfaceSource> source;
    source->SetSurface(&surface);
    source->SetWindow(100.0_nm, 400.0_nm, 200.0_nm, 500.0_nm);
    source->SetResolution(40, 40);
    const auto area = [&source](double left, double right, double bottom, double top) {
        source->SetHole(left, right, bottom, top);
        source->Update();
        EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 40 * 40);
        expectFrontsAlongNormals(source->GetOutput());
        return areaOf(source->GetOutput());
    };
    constexpr double kAll = 300.0_nm * 300.0_nm;
    constexpr double kRounding = 1e-5 * kAll;  // points are single precision
    EXPECT_NEAR(area(0.0, 0.0, 0.0, 0.0), kAll, kRounding);
    EXPECT_NEAR(area(151.3_nm, 212.7_nm, 333.3_nm, 340.1_nm), kAll - 61.4_nm * 6.8_nm, kRounding);
    EXPECT_NEAR(area(100.0_nm, 150.0_nm, 300.0_nm, 500.0_nm), kAll - 50.0_nm * 200.0_nm, kRounding)
        << "along the window's edges";
    EXPECT_NEAR(area(0.0, 1.0_um, 300.0_nm, 350.0_nm), kAll - 300.0_nm * 50.0_nm, kRounding)
        << "across the whole window";
    EXPECT_NEAR(area(100.0_nm, 400.0_nm, 200.0_nm, 500.0_nm), 0.0, kRounding);
}

TEST(SurfaceSource, BoundsAreTheWindow) {
    const BSplineSurface surface = test::eggBox();
    vtkNew<vtkAspSurfaceSource> source;
    source->SetSurface(&surface);
    source->SetWindow(0.0, surface.sizeX(), 0.0, surface.sizeY());
    source->SetResolution(128, 128);
    source->Update();
    const double* bounds = source->GetOutput()->GetBounds();
    EXPECT_NEAR(bounds[0], 0.0, 1e-15);
    EXPECT_NEAR(bounds[1], 1.0_um, 1e-12);
    EXPECT_NEAR(bounds[2], 0.0, 1e-15);
    EXPECT_NEAR(bounds[3], 1.0_um, 1e-12);
    EXPECT_NEAR(bounds[4], -20.0_nm, 0.2_nm);
    EXPECT_NEAR(bounds[5], 20.0_nm, 0.2_nm);
}

TEST(SurfaceSource, ANewSurfaceIsSampledAgain) {
    const BSplineSurface low = test::splineOf(8, 1.0_nm, [](double, double) { return 1.0_nm; });
    const BSplineSurface high = test::splineOf(8, 1.0_nm, [](double, double) { return 2.0_nm; });
    vtkNew<vtkAspSurfaceSource> source;
    source->SetWindow(0.0, 8.0_nm, 0.0, 8.0_nm);
    source->SetSurface(&low);
    source->Update();
    EXPECT_NEAR(scalarOf(source->GetOutput(), "height", 0), 1.0_nm, 1e-15);
    source->SetSurface(&high);
    source->Update();
    EXPECT_NEAR(scalarOf(source->GetOutput(), "height", 0), 2.0_nm, 1e-15);
}

TEST(PatchSource, DisplacementIsPositiveWhereTheSurfaceIsPushedIn) {
    vtkNew<vtkAspPatchSource> source;
    source->SetPatch(test::hertzDent().patch);
    source->Update();
    vtkPolyData* output = source->GetOutput();
    ASSERT_EQ(output->GetNumberOfPoints(), 121 * 121);
    EXPECT_EQ(output->GetNumberOfStrips(), 120);
    const vtkIdType middle = 60 * 121 + 60;
    EXPECT_NEAR(scalarOf(output, "displacement", middle), 0.6_nm, 1e-15);
    EXPECT_NEAR(pointOf(output, middle).z(), 5.0_nm - 0.6_nm, 1e-18);
    expectFrontsAlongNormals(output);

    source->SetPatch(test::adhesionNeck().patch);
    source->Update();
    EXPECT_NEAR(scalarOf(source->GetOutput(), "displacement", middle),
                4.0_nm * 1.0_nm / 15.0_nm - 0.6_nm, 1e-15);
}

TEST(PatchSource, DisplacementIsMeasuredAlongTheRestNormalOfASlope) {
    SurfacePatch patch;
    patch.columns = 3;
    patch.rows = 3;
    const Vector3 normal = Vector3(-1.0, 0.0, 1.0).normalized();  // of the plane z = x
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            patch.rest.emplace_back(column * 1.0_nm, row * 1.0_nm, column * 1.0_nm);
            patch.points.emplace_back(patch.rest.back() - 0.25_nm * normal);
            patch.normals.push_back(normal);
        }
    }
    vtkNew<vtkAspPatchSource> source;
    source->SetPatch(patch);
    source->Update();
    for (vtkIdType id = 0; id < 9; ++id) {
        EXPECT_NEAR(scalarOf(source->GetOutput(), "displacement", id), 0.25_nm, 1e-21);
    }
}

TEST(PatchSource, RefusesAPatchWhoseArraysDoNotMatch) {
    vtkObject::GlobalWarningDisplayOff();
    vtkNew<vtkAspPatchSource> source;
    SurfacePatch patch = test::hertzDent().patch;
    patch.normals.pop_back();
    source->SetPatch(patch);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
    vtkObject::GlobalWarningDisplayOn();
}

TEST(TipSource, SphereRunsSmoothlyIntoTheShank) {
    constexpr double kRadius = 15.0_nm;
    constexpr double kHalfAngle = 0.35;
    vtkNew<vtkAspTipSource> tip;
    tip->SetCenter(100.0_nm, 200.0_nm, 30.0_nm);
    tip->SetRadius(kRadius);
    tip->SetHalfAngle(kHalfAngle);
    tip->SetHeight(100.0_nm);
    tip->Update();
    vtkPolyData* output = tip->GetOutput();
    const Vector3 center(100.0_nm, 200.0_nm, 30.0_nm);
    const double tangentHeight = -kRadius * std::sin(kHalfAngle);
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id) {
        const Vector3 arm = pointOf(output, id) - center;
        const Vector3 normal = normalOf(output, id);
        if (normal.z() > 0.5) {
            EXPECT_NEAR(arm.z(), 85.0_nm, 1e-15) << "the flat end";
            continue;
        }
        // Sphere and cone alike: the tangent plane passes the center at one radius.
        EXPECT_NEAR(arm.dot(normal), kRadius, 1e-6 * kRadius);
        EXPECT_NEAR(normal.norm(), 1.0, 1e-6);
        if (arm.z() > tangentHeight + 1e-6 * kRadius) {
            EXPECT_NEAR(normal.z(), -std::sin(kHalfAngle), 1e-6);
        }
    }
    const double* bounds = output->GetBounds();
    EXPECT_NEAR(bounds[4], 15.0_nm, 1e-15);
    EXPECT_NEAR(bounds[5], 115.0_nm, 1e-15);
    expectFrontsAlongNormals(output);
}

TEST(TipSource, RingsAlongTheShankLieOnIt) {
    vtkNew<vtkAspTipSource> tip;
    tip->SetRadius(10.0_nm);
    tip->SetHalfAngle(0.3);
    tip->SetHeight(60.0_nm);
    tip->Update();
    const vtkIdType points = tip->GetOutput()->GetNumberOfPoints();
    tip->SetShankRings(5);
    tip->Update();
    vtkPolyData* output = tip->GetOutput();
    EXPECT_EQ(output->GetNumberOfPoints(), points + 4 * (tip->GetResolution() + 1));
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id) {
        if (normalOf(output, id).z() < 0.5) {
            EXPECT_NEAR(pointOf(output, id).dot(normalOf(output, id)), 10.0_nm, 1e-6 * 10.0_nm);
        }
    }
    expectFrontsAlongNormals(output);
}

TEST(TipSource, AParaboloidGoesOnWithTheSlopeOfItsEnd) {
    vtkNew<vtkAspTipSource> tip;
    tip->SetRadius(10.0_nm);
    tip->SetParaboloidReach(20.0_nm);
    tip->SetHeight(60.0_nm);
    tip->Update();
    vtkPolyData* output = tip->GetOutput();
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id) {
        const Vector3 point = pointOf(output, id);
        const double distance = point.head<2>().norm();
        const double above = point.z() + 10.0_nm;  // the apex
        if (normalOf(output, id).z() > 0.5) {
            EXPECT_NEAR(above, 60.0_nm, 1e-15);
        } else if (distance < 20.1_nm) {
            EXPECT_NEAR(above, distance * distance / 20.0_nm, 1e-15);
        } else {
            EXPECT_NEAR(above, 20.0_nm + 2.0 * (distance - 20.0_nm), 1e-15);
        }
    }
    expectFrontsAlongNormals(output);
}

TEST(TipSource, ALowTipIsACapOfTheSphere) {
    vtkNew<vtkAspTipSource> tip;
    tip->SetRadius(10.0_nm);
    tip->SetHeight(2.0_nm);
    tip->Update();
    const double* bounds = tip->GetOutput()->GetBounds();
    EXPECT_NEAR(bounds[5], -8.0_nm, 1e-15);
    EXPECT_NEAR(bounds[1], 6.0_nm, 1e-15);  // 10^2 - 8^2 = 6^2
}

TEST(ForceGlyph, PointsAlongTheForceAndIsAsLongAsTheScaleSays) {
    const Vector3 start(3.0_nm, -2.0_nm, 5.0_nm);
    const Vector3 force(30.0_nN, 0.0, 40.0_nN);
    vtkNew<vtkAspForceGlyphSource> arrow;
    arrow->SetContactPoint(start.x(), start.y(), start.z());
    arrow->SetForce(force.x(), force.y(), force.z());
    arrow->SetMetersPerNewton(0.2);
    arrow->Update();
    double shortest = 1.0;
    double longest = -1.0;
    for (vtkIdType id = 0; id < arrow->GetOutput()->GetNumberOfPoints(); ++id) {
        const double along = (pointOf(arrow->GetOutput(), id) - start).dot(force.normalized());
        shortest = std::min(shortest, along);
        longest = std::max(longest, along);
    }
    EXPECT_NEAR(shortest, 0.0, 1e-18);
    EXPECT_NEAR(longest, 10.0_nm, 1e-16);
    expectFrontsAlongNormals(arrow->GetOutput());
}

TEST(ForceGlyph, NothingIsDrawnForNoForce) {
    vtkNew<vtkAspForceGlyphSource> arrow;
    arrow->SetForce(0.0, 0.0, 1.0_nN);
    arrow->Update();
    EXPECT_GT(arrow->GetOutput()->GetNumberOfPoints(), 0);
    arrow->SetForce(0.0, 0.0, 0.0);
    arrow->Update();
    EXPECT_EQ(arrow->GetOutput()->GetNumberOfPoints(), 0);
    arrow->SetForce(vtkMath::Nan(), 0.0, 0.0);
    arrow->Update();
    EXPECT_EQ(arrow->GetOutput()->GetNumberOfPoints(), 0);
}

}  // namespace asperity
