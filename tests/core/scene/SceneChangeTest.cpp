#include "core/scene/Scene.h"
#include "core/scene/SceneFields.h"
#include "tests/core/scene/FieldTexts.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace asperity {
namespace {

SceneDescription with(const std::function<void(SceneDescription&)>& change) {
    SceneDescription scene = defaultScene();
    change(scene);
    return scene;
}

TEST(SceneChange, TellsWhatMustBeMadeAnew) {
    const SceneDescription scene = defaultScene();
    const auto changeTo = [&](const auto& change) { return changeBetween(scene, with(change)); };
    EXPECT_EQ(changeTo([](auto&) {}), SceneChange::None);
    EXPECT_EQ(changeTo([](auto& s) { s.setpoint = 1e-9; }), SceneChange::Shown);
    EXPECT_EQ(changeTo([](auto& s) { s.zoomHalfWidth = 1e-7; }), SceneChange::Shown);
    EXPECT_EQ(changeTo([](auto& s) { s.markers.push_back({.name = "a"}); }), SceneChange::Shown);
    EXPECT_EQ(changeTo([](auto& s) { s.settings.forceGain = 2.0; }), SceneChange::Shown);
    EXPECT_EQ(changeTo([](auto& s) { s.uncertainty.stiffness = 0.2; }), SceneChange::Shown);
    EXPECT_EQ(changeTo([](auto& s) { s.uncertainty.surfaceNormal = 0.1; }), SceneChange::Model)
        << "the tick reads it";
    EXPECT_EQ(changeTo([](auto& s) { s.uncertainty.enabled = false; }), SceneChange::Model);
    EXPECT_EQ(changeTo([](auto& s) { s.tip.radius = 1e-8; }), SceneChange::Model);
    EXPECT_EQ(changeTo([](auto& s) { s.tickRate = 2000.0; }), SceneChange::Model);
    EXPECT_EQ(changeTo([](auto& s) { s.sample.material.name = "b"; }), SceneChange::Model);
    EXPECT_EQ(changeTo([](auto& s) {
                  s.setpoint = 1e-9;
                  s.tip.radius = 1e-8;
              }),
              SceneChange::Model);
    EXPECT_EQ(changeTo([](auto& s) { s.sample.leveling = {}; }), SceneChange::Surface);
    EXPECT_EQ(changeTo([](auto& s) { s.sample.channel = "Phase"; }), SceneChange::Surface);
}

/// A key that the surface is made from, and that changed nothing, would be told by nobody.
TEST(SceneChange, EveryKeyOfAScanOrShapeMakesTheSurfaceAnew) {
    SceneDescription ball = defaultScene();
    ball.sample.shape = ShapeDescription{};
    for (const SceneField& field : sceneFields()) {
        const bool isOfShape = field.group == SceneGroup::Shape;
        if (field.group != SceneGroup::Sample && !isOfShape) {
            continue;
        }
        const SceneDescription& before = isOfShape ? ball : defaultScene();
        SceneDescription after = before;
        const SceneValue now = field.get(before);
        if (const auto* const number = std::get_if<double>(&now)) {
            field.set(after, *number + 1e-9);
        } else if (const auto* const on = std::get_if<bool>(&now)) {
            field.set(after, !*on);
        } else if (field.input == SceneInput::Positions) {
            field.set(after, std::string("1 2, 3 4, 5 7"));
        } else if (field.refusal != nullptr && field.input == SceneInput::Text) {
            field.set(after, std::string(test::textOf(field)));
        } else {
            field.set(after, std::string(field.input == SceneInput::Steps ? "zero" : "plane"));
        }
        EXPECT_EQ(changeBetween(before, after), SceneChange::Surface) << nameOf(field);
    }
}

TEST(SceneChange, AdoptsWhatIsShownAndNothingElse) {
    SceneDescription scene = defaultScene();
    SceneDescription other = with([](auto& s) {
        s.setpoint = 1e-9;
        s.markers.push_back({.name = "a"});
        s.tip.radius = 1e-8;
    });
    adoptShown(scene, other);
    EXPECT_EQ(scene.setpoint, 1e-9);
    EXPECT_EQ(scene.markers, other.markers);
    EXPECT_EQ(scene.tip.radius, defaultScene().tip.radius);
}

}  // namespace
}  // namespace asperity
