#include "core/scene/SceneFields.h"

#include "tests/core/scene/FieldTexts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace asperity {
namespace {

/// Where the field means something.
SceneDescription sceneFor(const SceneField& field) {
    SceneDescription scene = defaultScene();
    if (field.group == SceneGroup::Shape) {
        scene.sample.shape = ShapeDescription{};
    }
    return scene;
}

/// Another value that the key can have.
SceneValue anotherValue(const SceneField& field, const SceneValue& now) {
    if (const auto* const number = std::get_if<double>(&now)) {
        const double larger = *number == 0.0 ? field.words.scale * 0.25 : 1.25 * *number;
        return field.input == SceneInput::Whole ? std::round(larger + 1.0) : larger;
    }
    if (const auto* const on = std::get_if<bool>(&now)) {
        return !*on;
    }
    for (const SceneChoice& choice : field.choices) {
        if (choice.key != std::get<std::string>(now)) {
            return choice.key;
        }
    }
    switch (field.input) {
    case SceneInput::Steps:
        return std::string("plane, zero");
    case SceneInput::Positions:
        return std::string("10 20, 30 40, 50 10");
    default:
        return std::string(field.refusal == nullptr ? "another" : test::textOf(field));
    }
}

TEST(SceneFields, EachReadsWhatItSets) {
    for (const SceneField& field : sceneFields()) {
        SceneDescription scene = sceneFor(field);
        const SceneValue before = field.get(scene);
        const SceneValue value = anotherValue(field, before);
        ASSERT_NE(value, before) << nameOf(field);
        field.set(scene, value);
        const SceneValue after = field.get(scene);
        if (const auto* const number = std::get_if<double>(&after)) {
            EXPECT_NEAR(*number, std::get<double>(value), 1e-12 * std::abs(*number))
                << nameOf(field);
        } else {
            EXPECT_EQ(after, value) << nameOf(field);
        }
        EXPECT_NE(scene, sceneFor(field)) << nameOf(field);
    }
}

TEST(SceneFields, DefaultsLieWithinTheLimits) {
    for (const SceneField& field : sceneFields()) {
        const SceneValue value = field.get(sceneFor(field));
        if (const auto* const number = std::get_if<double>(&value)) {
            EXPECT_TRUE(field.limits.hold(*number)) << nameOf(field) << " " << *number;
        }
    }
}

TEST(SceneFields, NoneIsListedTwiceAndEachHasWords) {
    std::set<std::string> names;
    for (const SceneField& field : sceneFields()) {
        EXPECT_TRUE(names.insert(nameOf(field)).second) << nameOf(field);
        EXPECT_NE(std::string(field.words.caption), "") << nameOf(field);
        EXPECT_NE(std::string(field.words.toolTip), "") << nameOf(field);
    }
}

TEST(SceneFields, BothSidesOfAScanAreGivenOrNone) {
    SceneDescription scene = defaultScene();
    const auto set = [&](const std::string& name, double value) {
        for (const SceneField& field : sceneFields()) {
            if (nameOf(field) == name) {
                field.set(scene, value);
            }
        }
    };
    set("sample.size_x_m", 2e-6);
    EXPECT_EQ(scene.sample.scale.sizeY, 2e-6) << "square at first";
    set("sample.size_y_m", 1e-6);
    EXPECT_EQ(scene.sample.scale.sizeX, 2e-6);
    set("sample.size_y_m", 0.0);
    EXPECT_FALSE(scene.sample.scale.hasSize());
}

TEST(SceneFields, TextsThatAreNoValueAreRefused) {
    for (const SceneField& field : sceneFields()) {
        if (field.refusal != nullptr) {
            EXPECT_NE(field.refusal("nonsense"), "") << nameOf(field);
            EXPECT_NE(field.refusal("1, 2, 3"), "") << nameOf(field);
            const SceneValue usual = field.get(defaultScene());
            EXPECT_EQ(field.refusal(std::get<std::string>(usual)), "") << nameOf(field);
        }
    }
}

TEST(SceneFields, ANumberInAUnitIsRoundedOnce) {
    EXPECT_EQ(fromUnit(5.0, 1e-9), 5e-9);
    EXPECT_EQ(fromUnit(0.3, 1e9), 0.3e9);
    EXPECT_EQ(fromUnit(66.0, 1e-3), 0.066);
    EXPECT_NEAR(fromUnit(90.0, 0.017453292519943295), 1.5707963267948966, 1e-15);
}

}  // namespace
}  // namespace asperity
