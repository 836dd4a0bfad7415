#include "core/Error.h"
#include "core/io/scene/SceneFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

using testing::HasSubstr;

class MarkerKeys : public testing::Test {
protected:
    SceneDescription read(const std::string& text) {
        return readScene(scratch.write("scene.toml", "[sample]\nfile = \"map.gsf\"\n" + text));
    }
    std::string refusal(const std::string& text) {
        return test::refusalOf([&] { (void)read(text); });
    }

    test::ScratchFolder scratch;
};

TEST_F(MarkerKeys, AreReadInOrder) {
    EXPECT_TRUE(read("").markers.empty());
    EXPECT_TRUE(read("").markers.empty());
    const SceneDescription scene = read("[[marker]]\nname = \"edge\"\nx_m = 1e-6\ny_m = 2e-7\n"
                                        "[[marker]]\nname = \"a dip\"\nx_m = 0\ny_m = -3e-7\n");
    EXPECT_EQ(scene.markers, (std::vector<Marker>{{.name = "edge", .x = 1e-6, .y = 2e-7},
                                                  {.name = "a dip", .x = 0.0, .y = -3e-7}}));
}

TEST_F(MarkerKeys, ReadBackFromASceneOfAMapAndOfAShape) {
    SceneDescription scene = read("");
    scene.markers = {{.name = "Grain \"7\"", .x = 1.0 / 3.0, .y = 1e-9},
                     {.name = "\xc3\xa4", .x = 0.0, .y = 0.0}};
    EXPECT_EQ(readScene(scratch.write("back.toml", sceneText(scene))).markers, scene.markers);
    scene.sample.shape = ShapeDescription{};
    scene.sample.file.clear();
    EXPECT_EQ(readScene(scratch.write("shape.toml", sceneText(scene))).markers, scene.markers);
    scene.markers.clear();
    EXPECT_EQ(sceneText(scene).find("marker"), std::string::npos);
}

TEST_F(MarkerKeys, RefusesMistakes) {
    const std::string good = "[[marker]]\nname = \"edge\"\nx_m = 1e-6\ny_m = 2e-7\n";
    EXPECT_THAT(refusal(good + good), HasSubstr("two markers have the name 'edge'"));
    EXPECT_THAT(refusal("[[marker]]\nx_m = 1\ny_m = 1\n"), HasSubstr("needs a name"));
    EXPECT_THAT(refusal("[[marker]]\nname = \"a\"\nx_m = 1\n"), HasSubstr("y_m: expected"));
    EXPECT_THAT(refusal("[[marker]]\nname = \"a\"\nx_m = inf\ny_m = 1\n"), HasSubstr("finite"));
    EXPECT_THAT(refusal("[[marker]]\nname = \"a\"\nx_m = \"1\"\ny_m = 1\n"),
                HasSubstr("line 5, x_m: expected a number"));
    EXPECT_THAT(refusal(good + "z_m = 1\n"), HasSubstr("line 7: unknown key 'z_m'"));
    EXPECT_THAT(refusal("[marker]\nname = \"a\"\n"), HasSubstr("written [[marker]]"));
}

}  // namespace
}  // namespace asperity
