#include "core/Error.h"
#include "core/Units.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/ModelTerm.h"
#include "core/scene/SceneDescription.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace asperity {
namespace {

std::string refusalOf(const SceneDescription& scene) {
    try {
        checkTerms(scene);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

SceneDescription sceneWith(const ModelChoices& terms) {
    SceneDescription scene = test::plainScene();
    scene.choices = terms;
    return scene;
}

TEST(TermChecks, TermsThatALawHasRoomForMayBeOn) {
    EXPECT_EQ(refusalOf(sceneWith({})), "");
    EXPECT_EQ(refusalOf(sceneWith({.adhesion = true, .vanDerWaalsTail = true})), "");
    EXPECT_EQ(refusalOf(sceneWith({.vanDerWaalsTail = false, .sphereCorrection = true})), "");
    EXPECT_EQ(refusalOf(sceneWith({.vanDerWaalsTail = true, .sphereCorrection = true})), "");
    EXPECT_EQ(refusalOf(sceneWith({.adhesion = false, .vanDerWaalsTail = false})), "");
}

TEST(TermChecks, WhatNoLawHasTogetherIsRefused) {
    EXPECT_EQ(refusalOf(sceneWith({.sphereCorrection = true, .curvature = true})),
              "[fidelity]: sphere_correction cannot be on: curvature is on, and no contact law has "
              "both");
    EXPECT_EQ(refusalOf(sceneWith({.adhesion = false, .vanDerWaalsTail = true})),
              "[fidelity]: van_der_waals_tail cannot be on: adhesion is off");
    SceneDescription film = sceneWith({.adhesion = true, .filmBase = true});
    film.sample.material.filmThickness = 10.0_nm;
    EXPECT_EQ(refusalOf(film),
              "[fidelity]: adhesion cannot be on: film_base is on, and no contact law has both");
}

TEST(TermChecks, WhatTheSampleHasNotIsRefused) {
    EXPECT_EQ(refusalOf(sceneWith({.filmBase = true})),
              "[fidelity]: film_base cannot be on: the sample's film_thickness_m is 0");
    SceneDescription scene = sceneWith({.adhesion = true});
    scene.sample.material.workOfAdhesion = 0.0;
    EXPECT_EQ(refusalOf(scene),
              "[fidelity]: adhesion cannot be on: the sample's work_of_adhesion_j_m2 is 0");
}

TEST(TermChecks, TwoWorksOfAdhesionNeedALawOfJkrAndMoreOnRetract) {
    const auto refusal = [](std::optional<ContactLaw> law, double retractWork, bool isTruth) {
        SceneDescription scene = test::plainScene();
        scene.choices.law = law;
        SampleMaterial& material = isTruth ? scene.truth.material : scene.sample.material;
        material.retractWork = retractWork;
        try {
            checkScene(scene);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const double work = test::plainScene().sample.material.workOfAdhesion;
    EXPECT_EQ(refusal(ContactLaw::SphereJkr, 1.2 * work, false), "");
    EXPECT_EQ(refusal(ContactLaw::Jkr, work, true), "");
    EXPECT_NE(refusal(ContactLaw::Jkr, 0.9 * work, false).find("at least work_of_adhesion_j_m2"),
              std::string::npos);
    EXPECT_EQ(refusal(std::nullopt, 1.2 * work, true), "");
    EXPECT_EQ(refusal(ContactLaw::Split, 1.2 * work, true),
              "[truth]: retract_work_of_adhesion_j_m2 needs [physics] law jkr, jkr_sphere or auto, "
              "whose contacts have an edge");
}

/// The law that has the two works is taken where none is asked for.
TEST(TermChecks, TwoWorksOfAdhesionChooseALawWithAnEdge) {
    SceneDescription scene = test::plainScene();
    scene.sample.material.retractWork = 1.2 * scene.sample.material.workOfAdhesion;
    EXPECT_EQ(usualModel(scene).law, ContactLaw::Jkr);
    EXPECT_TRUE(usualModel(scene).retractWork);
    EXPECT_EQ(believedSystem(scene, usualModel(scene)).contact.adhesionRatio(), 1.2);
    scene.choices.retractWork = false;
    EXPECT_EQ(believedSystem(scene, usualModel(scene)).contact.adhesionRatio(), 1.0);
}

TEST(TermChecks, RelaxationAndDragNeedAllTheirValues) {
    const auto refusal = [](const auto& change) {
        SceneDescription scene = test::plainScene();
        scene.sample.material.workOfAdhesion = 0.0;
        change(scene.sample.material);
        try {
            checkScene(scene);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto relax = [](SampleMaterial& material) {
        material.relaxingModulus = 1e3;
        material.relaxationTime = 0.1;
    };
    EXPECT_EQ(refusal(relax), "");
    EXPECT_NE(refusal([](SampleMaterial& m) { m.relaxingModulus = 1e3; }).find("relaxation_time_s"),
              std::string::npos);
    EXPECT_NE(refusal([](SampleMaterial& m) { m.drag = 1e-11; }).find("drag_offset_m"),
              std::string::npos);
    EXPECT_NE(refusal([&](SampleMaterial& m) {
                  relax(m);
                  m.workOfAdhesion = 0.05;
              }).find("work_of_adhesion_j_m2 = 0"),
              std::string::npos);
}

TEST(TermChecks, ALawAndItsTermsAreNotBothSaid) {
    SceneDescription scene = sceneWith({.adhesion = false});
    scene.choices.law = ContactLaw::Jkr;
    EXPECT_EQ(refusalOf(scene),
              "[fidelity]: adhesion is the matter of [physics] law, which is jkr; leave out one of "
              "them");
    scene.choices = {.law = ContactLaw::Jkr, .friction = false};
    EXPECT_EQ(refusalOf(scene), "");
    scene.choices = {.law = ContactLaw::Jkr, .curvature = true};
    EXPECT_EQ(refusalOf(scene), "");
    scene.choices.law = ContactLaw::SphereMaugis;
    EXPECT_EQ(refusalOf(scene),
              "[fidelity]: curvature cannot be on: [physics] law is md_sphere, which takes the "
              "sample as flat");
}

TEST(TermChecks, ASceneIsHeldToThem) {
    EXPECT_THROW(checkScene(sceneWith({.filmBase = true})), Error);
}

}  // namespace
}  // namespace asperity
