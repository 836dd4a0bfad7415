#include "ui/view/TerrainLayer.h"

#include "core/Units.h"
#include "tests/ui/view/ViewMoments.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {

namespace {

const TerrainArea kArea{
    .window = {.left = 20.0_nm, .right = 100.0_nm, .bottom = 20.0_nm, .top = 100.0_nm},
    .hole = {.left = 45.0_nm, .right = 75.0_nm, .bottom = 40.0_nm, .top = 70.0_nm},
    .patch = {.left = 44.0_nm, .right = 76.0_nm, .bottom = 39.0_nm, .top = 71.0_nm}};

const SurfaceColors kColors;
const TerrainStyle kStyle{.colors = kColors, .space = {}, .shading = {ViewCamera(), {}, {}}};

/// Whether any visible triangle or line covers the position, seen from above.
class SeenFromAbove {
public:
    explicit SeenFromAbove(vtkRenderer* renderer) : renderer_(renderer) {}

    [[nodiscard]] double areaOfStrips() const {
        double area = 0.0;
        forEachCell([&](vtkPolyData* data, vtkIdType count, const vtkIdType* ids) {
            for (vtkIdType i = 0; i + 2 < count; ++i) {
                const Vector3 a(data->GetPoint(ids[i]));
                const Vector3 b = Vector3(data->GetPoint(ids[i + 1])) - a;
                const Vector3 c = Vector3(data->GetPoint(ids[i + 2])) - a;
                area += 0.5 * std::abs(b.x() * c.y() - b.y() * c.x());
            }
        });
        return area;
    }

    /// Of walls that face left or right; of level ground nothing.
    [[nodiscard]] double areaFromTheSide() const {
        double area = 0.0;
        forEachCell([&](vtkPolyData* data, vtkIdType count, const vtkIdType* ids) {
            for (vtkIdType i = 0; i + 2 < count; ++i) {
                const Vector3 a(data->GetPoint(ids[i]));
                const Vector3 b = Vector3(data->GetPoint(ids[i + 1])) - a;
                const Vector3 c = Vector3(data->GetPoint(ids[i + 2])) - a;
                area += 0.5 * std::abs(b.y() * c.z() - b.z() * c.y());
            }
        });
        return area;
    }

    [[nodiscard]] vtkIdType points() const {
        vtkIdType most = 0;
        forEachCell([&](vtkPolyData* data, vtkIdType, const vtkIdType*) {
            most = std::max(most, data->GetNumberOfPoints());
        });
        return most;
    }

private:
    template <class Visit>
    void forEachCell(const Visit& visit) const {
        vtkActorCollection* actors = renderer_->GetActors();
        actors->InitTraversal();
        while (vtkActor* actor = actors->GetNextActor()) {
            auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
            if (actor->GetVisibility() == 0 || data->GetNumberOfStrips() == 0) {
                continue;
            }
            vtkIdType count = 0;
            const vtkIdType* ids = nullptr;
            vtkCellArray* strips = data->GetStrips();
            for (strips->InitTraversal(); strips->GetNextCell(count, ids) != 0;) {
                visit(data, count, ids);
            }
        }
    }

    vtkRenderer* renderer_;
};

}  // namespace

TEST(TerrainLayer, CoversItsWindowButForTheHole) {
    const Scene scene = test::hillyScene();
    vtkNew<vtkRenderer> renderer;
    TerrainLayer terrain(renderer);
    EXPECT_EQ(SeenFromAbove(renderer).areaOfStrips(), 0.0);
    terrain.setArea(scene.surface, kArea);
    for (const TerrainDetail detail : {TerrainDetail::Coarse, TerrainDetail::Fine}) {
        terrain.show(detail, kStyle);
        EXPECT_NEAR(SeenFromAbove(renderer).areaOfStrips(), 5500e-18, 1e-20);
    }
    terrain.hide();
    EXPECT_EQ(SeenFromAbove(renderer).areaOfStrips(), 0.0);
}

TEST(TerrainLayer, HasNoWallWhereTheHoleLiesAtItsEdge) {
    const Scene scene = test::flatScene();
    vtkNew<vtkRenderer> renderer;
    TerrainLayer terrain(renderer);
    terrain.setBottom(-10.0_nm);
    const auto wallArea = [&](const ScanWindow& hole) {
        terrain.setArea(scene.surface, {.window = kArea.window, .hole = hole, .patch = hole});
        terrain.show(TerrainDetail::Fine, kStyle);
        return SeenFromAbove(renderer).areaFromTheSide();
    };
    const double whole = 2.0 * 80.0_nm * 10.0_nm;
    const double cell = 80.0_nm / 159.0 * 10.0_nm;
    EXPECT_NEAR(wallArea(kArea.hole), whole, 1e-6 * whole);
    const ScanWindow atEdge{20.0_nm, 50.0_nm, 40.0_nm, 70.0_nm};
    EXPECT_NEAR(wallArea(atEdge), whole - 30.0_nm * 10.0_nm, 1.5 * cell);
    const ScanWindow atCorner{70.0_nm, 100.0_nm, 20.0_nm, 50.0_nm};
    EXPECT_NEAR(wallArea(atCorner), whole - 30.0_nm * 10.0_nm, 1.5 * cell);
}

TEST(TerrainLayer, IsCoarseOrFineAsAsked) {
    const Scene scene = test::hillyScene();
    vtkNew<vtkRenderer> renderer;
    TerrainLayer terrain(renderer);
    terrain.setArea(scene.surface, kArea);
    terrain.show(TerrainDetail::Coarse, kStyle);
    EXPECT_LE(SeenFromAbove(renderer).points(), 80 * 80);
    terrain.show(TerrainDetail::Fine, kStyle);
    EXPECT_EQ(SeenFromAbove(renderer).points(), 160 * 160) << "four samples a pixel";
}

TEST(TerrainLayer, KnowsTheHeightsInItsWindow) {
    const Scene scene = test::hillyScene();
    vtkNew<vtkRenderer> renderer;
    TerrainLayer terrain(renderer);
    terrain.setArea(scene.surface, kArea);
    EXPECT_NEAR(terrain.heightRange()[0], -6.0_nm, 0.1_nm);
    EXPECT_NEAR(terrain.heightRange()[1], 6.0_nm, 0.1_nm);
}

}  // namespace asperity
