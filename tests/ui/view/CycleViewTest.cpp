// A whole cycle as the view draws it: approach, snap-in, dent, neck, pull-off.
#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ViewMoments.h"
#include "ui/view/ContactShape.h"
#include "ui/view/TipLayer.h"
#include "ui/view/ZoomPicture.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

constexpr int kHeight = 700;  // of the view [pixel]
constexpr int kWidth = 900;

Scene polystyreneOnSlope() { return buildScene(plainScene(), slopedMap(0.4)); }

Scene oxideScene() {
    SceneDescription description = plainScene();
    description.sample.material.elastic = {.youngsModulus = 72e9, .poissonRatio = 0.17};
    return buildScene(description, flatMap());
}

/// Dents of some ten nanometers, on the exact sphere.
Scene rubberScene() {
    HeightMap map = flatMap();
    map.pitchX *= 4.0;
    map.pitchY *= 4.0;
    SceneDescription description = plainScene();
    description.sample.material.elastic = {.youngsModulus = 2e6, .poissonRatio = 0.5};
    description.sample.material.workOfAdhesion = 0.04;
    return buildScene(description, map);
}

struct NamedScene {
    std::string name;
    std::function<Scene()> make;
    double indentation = 3e-9;  ///< of the base below first contact [m]
};

/// One tick as it is seen.
struct Seen {
    double tip = 0.0;    ///< height of the apex in the world [m]
    double apex = 0.0;   ///< and on the screen, upwards [pixel]
    double scale = 0.0;  ///< of the picture [m per pixel]
};

class Cycle : public ::testing::TestWithParam<NamedScene> {
protected:
    Cycle() {
        window->SetSize(kWidth, kHeight);
        QObject::connect(&picture, &ZoomPicture::terrainPlaced, [this] { aim(); });
        picture.setScene(&scene);
        aim();
    }

    void aim() { picture.aim(camera, static_cast<double>(kWidth) / kHeight); }

    void show(const TickSample& sample) {
        picture.setSample(sample);
        picture.showSample(camera, false);
    }

    [[nodiscard]] Seen seen(const TickSample& sample) const {
        const Vector3 apex = apexOf(tipContact(scene, sample.output.model));
        return {.tip = apex.z(),
                .apex = picture.drawnPosition(apex).y(),
                .scale = picture.metersPerPixel(kHeight)};
    }

    /// Some hundred ticks of an approach and a retract.
    std::vector<Seen> wholeCycle() {
        const PathPlan plan{
            .duration = 4.0, .indentation = GetParam().indentation, .slideLength = 0.0};
        SimulatedAfm afm(scene.surface, truthOf(scene));
        std::vector<Seen> all;
        int tick = 0;
        runVirtually(scene, slidePath(scene, plan), afm, 4000, [&](const TickSample& sample) {
            if (tick++ % 16 == 0) {
                show(sample);
                all.push_back(seen(sample));
            }
        });
        return all;
    }

    /// Lowest position of all that is drawn of the sample, world [m].
    double bottomOfBlock() {
        picture.showTerrain(camera, TerrainDetail::Coarse);
        window->GetRenderers()->InitTraversal();
        return window->GetRenderers()->GetNextItem()->ComputeVisiblePropBounds()[4];
    }

    const Scene scene = GetParam().make();
    const ViewCamera camera;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    ZoomPicture picture{window};
};

TEST_P(Cycle, ARetractingTipRisesOnTheScreenAndTheScaleStays) {
    const std::vector<Seen> all = wholeCycle();
    const auto isLower = [](const Seen& one, const Seen& other) { return one.tip < other.tip; };
    const auto deepest = std::min_element(all.begin(), all.end(), isLower);
    ASSERT_GT(all.end() - deepest, 50);
    for (auto tick = deepest; tick + 1 != all.end(); ++tick) {
        EXPECT_GE((tick + 1)->apex, tick->apex - 0.01) << tick - all.begin();
        EXPECT_EQ((tick + 1)->scale, tick->scale);
    }
    const double risen = all.back().tip - deepest->tip;
    EXPECT_NEAR((all.back().apex - deepest->apex) * deepest->scale, risen * camera.up().z(),
                0.02 * risen)
        << "true to scale";
}

TEST_P(Cycle, AnApproachingTipSinksOnTheScreen) {
    const std::vector<Seen> all = wholeCycle();
    const auto isLower = [](const Seen& one, const Seen& other) { return one.tip < other.tip; };
    const auto deepest = std::min_element(all.begin(), all.end(), isLower);
    for (auto tick = all.begin(); tick != deepest; ++tick) {
        EXPECT_LE((tick + 1)->apex, tick->apex + 0.01) << tick - all.begin();
        EXPECT_EQ((tick + 1)->scale, tick->scale);
    }
}

TEST_P(Cycle, TheBlockHoldsTheDentAndTheViewBoth) {
    const ViewMoments moments = momentsOf(scene, GetParam().indentation);
    show(moments.deep.sample);
    const TipState& state = moments.deep.sample.output.model;
    const double reach = picture.scale().patch;
    const ContactShape shape(
        scene, state, windowAround(state.tip.head<2>(), reach, picture.frame()->window()), 65);
    EXPECT_LT(bottomOfBlock(), shape.lowest() - 0.04 * picture.frame()->halfWidth());
    for (const Vector3& position : {shape.contactPoint(), Vector3(apexOf(shape.contact()))}) {
        const Vector2 drawn = picture.drawnPosition(position);
        EXPECT_GT(drawn.y(), 0.05 * kHeight);
        EXPECT_LT(drawn.y(), 0.95 * kHeight);
    }
}

/// The tip that is drawn is the one of the model, whatever it stands on.
TEST_P(Cycle, ARigidTipKeepsItsShapeAndStandsUpright) {
    Scene rigid = GetParam().make();
    rigid.model.deformation = DeformationModel::ContactRadius;  // moves the sample alone
    const ViewMoments moments = momentsOf(rigid);
    for (const Snapshot& moment : {moments.away, moments.deep, moments.neck}) {
        const TipState& state = moment.sample.output.model;
        const ContactShape shape(
            rigid, state, windowAround(state.tip.head<2>(), 30.0_nm, picture.frame()->window()),
            33);
        vtkNew<vtkRenderer> renderer;
        TipLayer layer(renderer);
        layer.show(shape,
                   {.height = 40.0_nm, .space = {}, .shading = {camera, DrawnSpace(), Light()}});
        const double radius = shape.contact().tipRadius;
        for (vtkIdType id = 0; id < layer.body()->GetNumberOfPoints(); ++id) {
            const Vector3 arm = Vector3(layer.body()->GetPoint(id)) - shape.contact().tipCenter;
            const double r = arm.cross(shape.outward()).norm();
            const double along = radius + arm.dot(shape.outward());  // above the contact's point
            if (along < 0.2 * radius) {
                const double paraboloid = r * r / (2.0 * radius);
                EXPECT_NEAR(along, paraboloid,
                            std::pow(r, 4) / (6.0 * std::pow(radius, 3)) + 1e-14);
            }
        }
        EXPECT_NEAR(layer.body()->GetBounds()[4], apexOf(shape.contact()).z(), 1e-13);
    }
}

INSTANTIATE_TEST_SUITE_P(Samples, Cycle,
                         ::testing::Values(NamedScene{"polystyrene", flatScene},
                                           NamedScene{"slope", polystyreneOnSlope},
                                           NamedScene{"hills", hillyScene},
                                           NamedScene{"oxide", oxideScene},
                                           NamedScene{"rubber", rubberScene},
                                           NamedScene{"rubber_deep", rubberScene, 36e-9}),
                         [](const auto& given) { return given.param.name; });

/// What is drawn of a force estimate.
class ArrowTest : public ::testing::Test {
protected:
    bool isDrawn(double force, double time) {
        ForceEstimate estimate;
        estimate.force = {0.0, 0.0, force};
        estimate.covariance = 1e-20 * Matrix3::Identity();  // 100 pN
        layer.show(estimate, Vector3::Zero(), time, 1e-9, 40.0_nm);
        return layer.end().has_value();
    }

    vtkNew<vtkRenderer> renderer;
    ForceLayer layer{renderer};
};

TEST_F(ArrowTest, AForceWithinThreeStandardDeviationsIsNotDrawn) {
    EXPECT_TRUE(isDrawn(5.0_nN, 0.0));
    EXPECT_FALSE(isDrawn(0.29_nN, 0.01));
    EXPECT_FALSE(isDrawn(0.5_nN, 0.02)) << "one tick of many";
    EXPECT_FALSE(isDrawn(0.1_nN, 0.03));
    EXPECT_FALSE(isDrawn(0.5_nN, 0.06));
    EXPECT_TRUE(isDrawn(0.5_nN, 0.1)) << "it has lasted";
    EXPECT_TRUE(isDrawn(0.5_nN, 0.0)) << "another run";
}

}  // namespace
}  // namespace asperity::test
