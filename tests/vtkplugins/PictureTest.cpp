#include "core/Error.h"
#include "core/Units.h"
#include "tests/vtkplugins/Fakes.h"
#include "tests/vtkplugins/NeedsDisplay.h"
#include "tests/vtkplugins/PictureFixture.h"
#include "vtkplugins/module/vtkAspPatchSource.h"
#include "vtkplugins/pictures/DeformationPicture.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/OverviewPicture.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace asperity {

namespace {

using test::Image;
using test::kSize;
using test::Pictures;

const std::string kLongText =
    "A caption that goes on for much longer than a line of the picture can hold, so that it must "
    "be broken into several lines, and says what was measured, with which tip, on which sample.";

bool isBlue(const std::array<int, 3>& rgb) { return rgb[2] > rgb[0] + 60; }
bool isOrange(const std::array<int, 3>& rgb) {
    return rgb[0] > rgb[2] + 90 && rgb[1] > rgb[2] + 20;
}

OverviewView overviewOf(const BSplineSurface& surface) {
    OverviewView view{.title = "Egg box", .caption = kLongText, .surface = surface};
    view.tip = Vector3(520.0_nm, 430.0_nm, 10.0_nm);
    view.zoom = ScanWindow{420.0_nm, 620.0_nm, 330.0_nm, 530.0_nm};
    for (int i = 0; i <= 100; ++i) {
        const double x = 200.0_nm + i * 6.0_nm;
        view.path.emplace_back(x, 430.0_nm, surface.at(x, 430.0_nm).height);
    }
    view.path.emplace_back(800.0_nm, 430.0_nm, 900.0_nm);  // far above: left out
    return view;
}

/// A slope across the view, looked at from not far above its own plane.
SurfacePatch steepPatch() {
    constexpr int kSide = 61;
    SurfacePatch patch{.columns = kSide, .rows = kSide, .rest = {}, .points = {}, .normals = {}};
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            patch.rest.emplace_back(0.5_nm * column, 0.5_nm * row, -0.15_nm * row);
        }
    }
    patch.points = patch.rest;
    patch.normals.assign(patch.rest.size(), Vector3(0.0, 0.3, 1.0).normalized());
    return patch;
}

/// Grid lines in black on paper; the surface under them, where there is one, as white as the paper.
void writeGrid(const std::filesystem::path& path, bool hasSurface) {
    OffscreenPicture picture(kSize);
    vtkRenderer* view = picture.addView({0.0, 0.0, kSize.width * 1.0, kSize.height * 1.0}, 1);
    vtkNew<vtkAspPatchSource> source;
    source->SetPatch(steepPatch());
    source->Update();
    if (hasSurface) {
        const vtkSmartPointer<vtkActor> surface =
            plainSurface(source->GetOutput(), {255, 255, 255});
        surface->GetProperty()->LightingOff();
        view->AddActor(surface);
    }
    view->AddActor(lines(drapedGrid(source->GetOutput(), {61, 61}, 24), {0, 0, 0}, 0.7));
    fitCamera(std::array{view}, Vector3(-0.28, -0.78, 0.5), 1.6);
    picture.writePng(path);
}

}  // namespace

TEST_F(Pictures, LinesOnASteepSurfaceAreWhole) {
    ASPERITY_NEEDS_DISPLAY();
    writeGrid(folder / "lines.png", false);
    writeGrid(folder / "surface.png", true);
    const auto isInk = [](const std::array<int, 3>& rgb) { return rgb[0] < 160; };
    const int lines = Image(folder / "lines.png").count(isInk);
    const int linesOnSurface = Image(folder / "surface.png").count(isInk);
    EXPECT_GT(lines, 10000);
    EXPECT_GT(linesOnSurface, 0.98 * lines);
}

TEST_F(Pictures, FourViewsStandInTwoRows) {
    ASPERITY_NEEDS_DISPLAY();
    const DeformationView dent = test::hertzDent();
    const Image image = drawn([&dent](const std::filesystem::path& path) {
        writeDeformationPicture(path, std::array{dent, dent, dent, dent}, kSize);
    });
    std::array<int, 4> blue{};
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int quarter = (2 * x / image.width()) + 2 * (2 * y / image.height());
            blue.at(static_cast<std::size_t>(quarter)) += isBlue(image.at(x, y)) ? 1 : 0;
        }
    }
    for (const int count : blue) {
        EXPECT_GT(count, 500);
        EXPECT_NEAR(count, blue[0], 0.02 * blue[0]);
    }
}

TEST_F(Pictures, DentIsBlueAndNeckIsOrange) {
    ASPERITY_NEEDS_DISPLAY();
    const DeformationView dent = test::hertzDent();
    const DeformationView neck = test::adhesionNeck();
    const Image dentImage = drawn([&](const std::filesystem::path& path) {
        writeDeformationPicture(path, std::array{dent}, kSize);
    });
    const Image neckImage = drawn([&](const std::filesystem::path& path) {
        writeDeformationPicture(path, std::array{neck}, kSize);
    });
    EXPECT_GT(dentImage.colors(), 1000U);
    EXPECT_GT(dentImage.count(isBlue), 10 * std::max(1, neckImage.count(isBlue)));
    EXPECT_GT(neckImage.count(isOrange), 10 * std::max(1, dentImage.count(isOrange)));
}

/// A tip as deep in rubber as the picture is wide: the block in front of it hid all of the contact.
DeformationView deepHole() {
    DeformationView view = test::hertzDent();
    SurfacePatch& patch = view.patch;
    const Vector3 middle = 0.5 * (patch.rest.front() + patch.rest.back());
    const double width = patch.rest.back().x() - patch.rest.front().x();
    for (std::size_t i = 0; i < patch.rest.size(); ++i) {
        const double away = (patch.rest[i] - middle).head<2>().norm() / (0.2 * width);
        patch.points[i].z() = patch.rest[i].z() - width * std::exp(-away * away);
    }
    patch.normals.assign(patch.rest.size(), Vector3::UnitZ());
    view.contactPoint = middle - Vector3(0.0, 0.0, width);
    view.tipRadius = 0.15 * width;
    view.contactRadius = 0.1 * width;
    view.tipCenter = view.contactPoint + Vector3(0.0, 0.0, view.tipRadius);
    return view;
}

TEST_F(Pictures, ABlockThatHidesTheContactIsCut) {
    ASPERITY_NEEDS_DISPLAY();
    const DeformationView deep = deepHole();
    const Image image = drawn([&](const std::filesystem::path& path) {
        writeDeformationPicture(path, std::array{deep}, kSize);
    });
    EXPECT_GT(image.count(isBlue), 4000) << "the bottom of the hole is seen";
}

TEST_F(Pictures, TwoViewsStandSideBySide) {
    ASPERITY_NEEDS_DISPLAY();
    DeformationView dent = test::hertzDent();
    dent.caption = kLongText + " " + kLongText + " " + kLongText;
    dent.title = kLongText;
    const std::array views{dent, test::adhesionNeck()};
    const Image image = drawn(
        [&](const std::filesystem::path& path) { writeDeformationPicture(path, views, kSize); });
    int blueLeft = 0;
    int blueRight = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            if (isBlue(image.at(x, y))) {
                (x < kSize.width / 2 ? blueLeft : blueRight) += 1;
            }
        }
    }
    EXPECT_GT(blueLeft, 10 * std::max(1, blueRight));
}

TEST_F(Pictures, AnUntouchedSurfaceWithoutForceIsDrawnToo) {
    ASPERITY_NEEDS_DISPLAY();
    DeformationView view = test::hertzDent();
    view.patch.points = view.patch.rest;
    view.patch.normals.assign(view.patch.rest.size(), Vector3::UnitZ());
    view.force.setZero();
    view.contactRadius = 0.0;
    view.tipCenter.z() += 5.0_nm;
    const Image image = drawn([&](const std::filesystem::path& path) {
        writeDeformationPicture(path, std::array{view}, kSize);
    });
    EXPECT_GT(image.colors(), 100U);
}

TEST_F(Pictures, OverviewMarksTipPathAndZoom) {
    ASPERITY_NEEDS_DISPLAY();
    const BSplineSurface surface = test::eggBox();
    const OverviewView marked = overviewOf(surface);
    const OverviewView bare{.title = "Egg box", .caption = kLongText, .surface = surface};
    const Image with = drawn(
        [&](const std::filesystem::path& path) { writeOverviewPicture(path, marked, kSize); });
    const Image without =
        drawn([&](const std::filesystem::path& path) { writeOverviewPicture(path, bare, kSize); });
    const auto isMarker = [](const std::array<int, 3>& rgb) {
        return rgb[0] > 150 && rgb[1] < 90 && rgb[2] < 130;
    };
    EXPECT_GT(with.colors(), 1000U);
    EXPECT_GT(with.count(isMarker), 200);
    EXPECT_EQ(without.count(isMarker), 0);
}

TEST_F(Pictures, OverviewIsGrayWhereTheScanHoldsNoData) {
    ASPERITY_NEEDS_DISPLAY();
    const BSplineSurface whole = test::eggBox();
    BSplineSurface::Grid grid = whole.grid();
    grid.invalid.assign(
        static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns), 0);
    std::fill_n(grid.invalid.begin(), grid.invalid.size() / 2, 1);
    const BSplineSurface holed(grid);
    const auto overviewWith = [&](const BSplineSurface& surface) {
        return drawn([&](const std::filesystem::path& path) {
            writeOverviewPicture(path, {.title = "Egg box", .caption = "", .surface = surface},
                                 kSize);
        });
    };
    const auto isColorful = [](const std::array<int, 3>& rgb) {
        return *std::ranges::max_element(rgb) - *std::ranges::min_element(rgb) > 40;
    };
    const int all = overviewWith(whole).count(isColorful);
    const int half = overviewWith(holed).count(isColorful);
    EXPECT_GT(all, 50000);
    EXPECT_GT(half, all / 4);
    EXPECT_LT(half, 3 * all / 4);
}

TEST_F(Pictures, AFlatScanHasAnOverviewToo) {
    ASPERITY_NEEDS_DISPLAY();
    const BSplineSurface flat = test::splineOf(16, 10.0_nm, [](double, double) { return 0.0; });
    const OverviewView view{.title = "Flat", .caption = "", .surface = flat};
    const Image image =
        drawn([&](const std::filesystem::path& path) { writeOverviewPicture(path, view, kSize); });
    EXPECT_GT(image.colors(), 20U);
}

TEST_F(Pictures, RefusesWhatCannotBeDrawn) {
    ASPERITY_NEEDS_DISPLAY();
    const std::filesystem::path path = folder / "picture.png";
    DeformationView broken = test::hertzDent();
    broken.patch.points.pop_back();
    EXPECT_THROW(writeDeformationPicture(path, std::array{broken}), Error);
    DeformationView lost = test::hertzDent();
    lost.force.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(writeDeformationPicture(path, std::array{lost}), Error);
    EXPECT_THROW(writeDeformationPicture(path, {}), Error);
    const std::array whole{test::hertzDent()};
    EXPECT_THROW(writeDeformationPicture(path, whole, {0, 100}), Error);
    EXPECT_THROW(writeDeformationPicture(folder / "missing" / "picture.png", whole), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

// NOLINTBEGIN(concurrency-mt-unsafe): tests have no other threads that read the environment
TEST_F(Pictures, WithoutADisplayTheErrorSaysWhatToDo) {
    const char* before = std::getenv("DISPLAY");
    const std::string display = before == nullptr ? "" : before;
    unsetenv("DISPLAY");
    try {
        writeDeformationPicture(folder / "picture.png", std::array{test::hertzDent()});
        ADD_FAILURE() << "drew without a display";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("xvfb-run"), std::string::npos);
    }
    if (!display.empty()) {
        setenv("DISPLAY", display.c_str(), 1);
    }
}
// NOLINTEND(concurrency-mt-unsafe)

}  // namespace asperity
