#include "tests/core/experiment/SmallStudy.h"

#include "core/Units.h"

namespace asperity::test {

Study smallStudy() {
    Study study;
    study.name = "small";
    study.scene = defaultScene();
    study.scene.sample.shape =
        ShapeDescription{.kind = ShapeKind::Plane, .slope = 0.0, .size = 400.0_nm};
    study.materials = {{.name = "silicon_oxide",
                        .elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27},
                        .workOfAdhesion = 0.2},
                       {.name = "polystyrene"},
                       {.name = "silicone_rubber",
                        .elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5},
                        .workOfAdhesion = 0.022}};
    study.levers = {{.name = "stiff", .probe = {.lever = study.scene.probe, .detector = {}}}};
    study.tasks = {{TaskKind::Above, 5.0_nm, 50.0_nm, {0, 1, 2}},
                   {TaskKind::On, 0.0, 0.0, {0, 1, 2}},
                   {TaskKind::Below, 2.0_nm, 2.0_nm, {1, 2}}};
    study.targets = {{30.0_nm, 20.0_nm}, {-20.0_nm, -30.0_nm}};
    study.repeats = 2;
    return study;
}

}  // namespace asperity::test
