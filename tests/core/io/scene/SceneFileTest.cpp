#include "core/io/scene/SceneFile.h"

#include "core/Error.h"
#include "core/io/scene/ProbeFile.h"
#include "core/scene/Scene.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace asperity {
namespace {

class SceneFile : public ::testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const std::string& text) {
        std::filesystem::path path = scratch.path() / name;
        std::ofstream(path) << text;
        return path;
    }

    /// The message of the refusal; empty when the scene was read.
    std::string refusal(const std::string& text) {
        return test::refusalOf([&] { (void)readScene(write("scene.toml", text)); });
    }

    test::ScratchFolder scratch;
};

TEST_F(SceneFile, FillsInDefaultsAndResolvesPathsAgainstItself) {
    const SceneDescription scene = readScene(write("scene.toml", "[sample]\nfile = \"map.gsf\"\n"));
    EXPECT_EQ(scene.sample.file, (scratch.path() / "map.gsf").string());
    EXPECT_EQ(scene.sample.leveling, LevelingSteps{LevelingStep::Plane});
    EXPECT_NEAR(Cantilever(scene.probe).stiffness(), 14.0, 1e-12);
    EXPECT_EQ(scene.truth.material.workOfAdhesion, scene.sample.material.workOfAdhesion);
}

TEST_F(SceneFile, ReadsKeysByTheirFormerNames) {
    const std::string start = "[sample]\nfile = \"map.gsf\"\n";
    const SceneDescription scene =
        readScene(write("former.toml", start + "[fidelity]\nfoot_search = \"global\"\n"
                                               "[haptics]\nmax_hand_speed_m_s = 1.25\n"));
    EXPECT_EQ(scene.choices.closestPointSearch, SearchEffort::Global);
    EXPECT_EQ(scene.settings.governor.maxDeviceSpeed, 1.25);
    const std::string written = sceneText(scene);
    EXPECT_NE(written.find("closest_point_search = 'global'"), std::string::npos) << written;
    EXPECT_NE(written.find("max_device_speed_m_s = 1.25"), std::string::npos) << written;
    EXPECT_EQ(written.find("foot_"), std::string::npos) << written;
    EXPECT_EQ(written.find("hand_"), std::string::npos) << written;
}

TEST_F(SceneFile, RefusesAKeyByItsFormerAndItsCurrentName) {
    const std::string start = "[sample]\nfile = \"map.gsf\"\n[haptics]\n";
    EXPECT_EQ(refusal(start + "max_hand_speed_m_s = 1\nmax_device_speed_m_s = 1\n"),
              (scratch.path() / "scene.toml").string() +
                  ": line 4: unknown key 'max_hand_speed_m_s' in [haptics]");
    EXPECT_EQ(refusal(start + "max_force_n = 1\nmax_hand_speed_m_s = true\n"),
              (scratch.path() / "scene.toml").string() +
                  ": line 5, [haptics] max_device_speed_m_s: expected a number");
}

TEST_F(SceneFile, SmoothsByPixelsOrByALength) {
    const SceneDescription pixels =
        readScene(write("px.toml", "[sample]\nfile = \"map.gsf\"\nsmoothing_px = 2.5\n"));
    EXPECT_EQ(pixels.sample.smoothingPixels, 2.5);
    EXPECT_EQ(pixels.sample.smoothingLength, 0.0);
    const SceneDescription length =
        readScene(write("m.toml", "[sample]\nfile = \"map.gsf\"\nsmoothing_m = 3e-9\n"));
    EXPECT_EQ(length.sample.smoothingLength, 3e-9);
    const SceneDescription none =
        readScene(write("none.toml", "[sample]\nfile = \"map.gsf\"\nsmoothing_m = 0\n"));
    EXPECT_EQ(none.sample.smoothingLength, 0.0);
    EXPECT_EQ(none.sample.smoothingPixels, 0.0);
}

TEST_F(SceneFile, LeavesTheSmoothingOpenUnlessItIsStated) {
    const std::string start = "[sample]\nfile = \"map.gsf\"\n";
    EXPECT_EQ(readScene(write("open.toml", start)).sample.smoothingPixels, std::nullopt);
    EXPECT_EQ(
        readScene(write("auto.toml", start + "smoothing_px = \"auto\"\n")).sample.smoothingPixels,
        std::nullopt);
    EXPECT_EQ(readScene(write("zero.toml", start + "smoothing_px = 0\n")).sample.smoothingPixels,
              0.0);
}

TEST_F(SceneFile, SaysTheScaleOfAScanWhoseFileDoesNot) {
    const std::string start = "[sample]\nfile = \"map.txt\"\n";
    const GivenScale none = readScene(write("none.toml", start)).sample.scale;
    EXPECT_FALSE(none.hasSize());
    EXPECT_FALSE(none.hasHeight());
    EXPECT_EQ(sceneText(readScene(write("none.toml", start))).find("size_x_m"), std::string::npos);
    const SceneDescription scene = readScene(
        write("given.toml", start + "size_x_m = 5e-6\nsize_y_m = 2e-6\nz_scale_m = 1.25e-10\n"));
    EXPECT_EQ(scene.sample.scale, (GivenScale{5e-6, 2e-6, 1.25e-10}));
    EXPECT_EQ(readScene(write("again.toml", sceneText(scene))).sample.scale, scene.sample.scale);
    const GivenScale height =
        readScene(write("height.toml", start + "z_scale_m = 1e-9\n")).sample.scale;
    EXPECT_FALSE(height.hasSize());
    EXPECT_EQ(height.heightPerValue, 1e-9);
}

TEST_F(SceneFile, TakesAPartOfTheMapInPixels) {
    const std::string start = "[sample]\nfile = \"map.gsf\"\n";
    EXPECT_FALSE(readScene(write("none.toml", start)).sample.crop);
    const SceneDescription scene =
        readScene(write("crop.toml", start + "crop_px = [20, 30, 100, 80]\n"));
    EXPECT_EQ(scene.sample.crop,
              (PixelRectangle{.column = 20, .row = 30, .columns = 100, .rows = 80}));
    EXPECT_EQ(readScene(write("again.toml", sceneText(scene))).sample.crop, scene.sample.crop);
    for (const char* wrong :
         {"5", "[1, 2, 3]", "[1, 2, 3, 4, 5]", "[0, 0, 0, 4]", "[0, 0, 4, 0]", "[-1, 0, 4, 4]",
          "[0, 0, 4.5, 4]", "[0, 0, \"4\", 4]", "[0, 0, 4, 3000000000]"}) {
        EXPECT_NE(refusal(start + "crop_px = " + wrong + "\n").find("line 3, [sample] crop_px"),
                  std::string::npos)
            << wrong;
    }
}

TEST_F(SceneFile, IsKnownByItsContentAlso) {
    const auto scene = write("scene.txt", "# a scene\n[sample]\nfile = \"map.gsf\"\n");
    EXPECT_EQ(sceneFromInput(scene).sample.file, (scratch.path() / "map.gsf").string());
    const auto map = write("map.txt", "no scene, [sample] or not");
    EXPECT_EQ(sceneFromInput(map).sample.file, map.string()) << "taken as a height map";
}

TEST_F(SceneFile, TakesAMaterialFileAndSingleKeysOverIt) {
    write("soft.toml", "name = \"soft\"\nyoungs_modulus_pa = 1e6\npoisson_ratio = 0.5\n");
    const SceneDescription scene = readScene(write("scene.toml", R"(
[sample]
file = "map.gsf"
material = "soft.toml"
poisson_ratio = 0.4
[truth]
youngs_modulus_pa = 2e6
noise_seed = 7
)"));
    EXPECT_EQ(scene.sample.material.name, "soft");
    EXPECT_EQ(scene.sample.material.elastic.youngsModulus, 1e6);
    EXPECT_EQ(scene.sample.material.elastic.poissonRatio, 0.4);
    EXPECT_EQ(scene.truth.material.elastic.youngsModulus, 2e6);
    EXPECT_EQ(scene.truth.material.elastic.poissonRatio, 0.4) << "the rest is as believed";
    EXPECT_EQ(scene.truth.noiseSeed, 7U);
}

/// "Not known" and "does not yield" are two values; of another modulus, neither is known.
TEST_F(SceneFile, SaysThatASampleDoesNotYield) {
    write("rubber.toml", "name = \"rubber\"\nyoungs_modulus_pa = 1e6\nyields = false\n");
    const std::string sample = "[sample]\nfile = \"map.gsf\"\nmaterial = \"rubber.toml\"\n";
    const SceneDescription scene = readScene(write("scene.toml", sample));
    EXPECT_FALSE(scene.sample.material.yields);
    EXPECT_FALSE(readScene(write("again.toml", sceneText(scene))).sample.material.yields);
    EXPECT_TRUE(
        readScene(write("hard.toml", sample + "youngs_modulus_pa = 3e9\n")).sample.material.yields);
    EXPECT_TRUE(
        readScene(write("plain.toml", "[sample]\nfile = \"map.gsf\"\n")).sample.material.yields);
}

TEST_F(SceneFile, KeepsTheConeOfTheTip) {
    const std::string sample = "[sample]\nfile = \"map.gsf\"\n";
    const SceneDescription scene =
        readScene(write("cone.toml", sample + "[tip]\ncone_half_angle_rad = 0.35\n"));
    EXPECT_EQ(scene.tip.coneHalfAngle, 0.35);
    EXPECT_EQ(readScene(write("again.toml", sceneText(scene))).tip.coneHalfAngle, 0.35);
    EXPECT_EQ(readScene(write("none.toml", sample)).tip.coneHalfAngle, 0.0);
}

TEST_F(SceneFile, TakesAShapeInPlaceOfAHeightMap) {
    const SceneDescription ball = readScene(write("ball.toml", R"(
[sample]
shape = "sphere"
shape_radius_m = 2e-7
shape_size_m = 1.5e-7
)"));
    EXPECT_EQ(ball.sample.shape,
              (ShapeDescription{.kind = ShapeKind::Sphere, .radius = 2e-7, .size = 1.5e-7}));
    EXPECT_TRUE(ball.sample.file.empty());
    const std::string text = sceneText(ball);
    EXPECT_EQ(sceneText(readScene(write("again.toml", text))), text);

    const SceneDescription slope = readScene(write("slope.toml", R"(
[sample]
shape = "plane"
shape_slope_rad = 0.3
)"));
    EXPECT_EQ(slope.sample.shape,
              (ShapeDescription{.kind = ShapeKind::Plane, .slope = 0.3, .size = 1e-7}));
    const std::string slopeText = sceneText(slope);
    EXPECT_EQ(sceneText(readScene(write("again.toml", slopeText))), slopeText);
}

/// One number, whichever file says it: a run replays with what it was run with.
TEST_F(SceneFile, ReadsTheNormalsDeviationOfEarlierFilesAndRuns) {
    const std::string sample = "[sample]\nfile = \"map.gsf\"\n";
    const auto path = write("none.toml", sample);
    EXPECT_EQ(readScene(path).uncertainty.surfaceNormal, 0.02);
    EXPECT_EQ(readRecordedScene(path).uncertainty.surfaceNormal, 0.0) << "of before";
    const auto now = write("now.toml", sample + "[uncertainty]\nsurface_normal_rad = 0.03\n");
    EXPECT_EQ(readScene(now).uncertainty.surfaceNormal, 0.03);
    EXPECT_EQ(readRecordedScene(now).uncertainty.surfaceNormal, 0.03);
    const auto both = write("both.toml", sample + "[probe]\nnormal_deviation_rad = 0.0\n"
                                                  "[uncertainty]\nsurface_normal_rad = 0.02\n");
    EXPECT_EQ(readRecordedScene(both).uncertainty.surfaceNormal, 0.0) << "what the estimator took";
}

TEST_F(SceneFile, ReadsTheSetpointOfAnApproach) {
    const std::string map = "[sample]\nfile = \"map.gsf\"\n";
    EXPECT_EQ(readScene(write("scene.toml", map)).setpoint, 5e-9);
    const SceneDescription scene =
        readScene(write("scene.toml", map + "[approach]\nsetpoint_n = 2e-10\n"));
    EXPECT_EQ(scene.setpoint, 2e-10);
    EXPECT_EQ(readScene(write("again.toml", sceneText(scene))).setpoint, 2e-10);
    EXPECT_NE(refusal(map + "[approach]\nsetpoint_n = 0\n").find("[approach] setpoint_n: must lie"),
              std::string::npos);
    EXPECT_NE(refusal(map + "[approach]\nsetpoint = 1e-9\n"), "");
}

TEST_F(SceneFile, RefusesAShapeThatIsNone) {
    const std::string path = (scratch.path() / "scene.toml").string();
    EXPECT_EQ(refusal("[sample]\nshape = \"cone\"\n"),
              path +
                  ": line 2, [sample] shape: expected one of sphere, cylinder, plane, not 'cone'");
    EXPECT_EQ(refusal("[sample]\nshape = \"sphere\"\nfile = \"map.gsf\"\n"),
              path +
                  ": line 2, [sample] shape: expected a shape or a height map ('file'), not both");
    EXPECT_NE(refusal("[sample]\nshape = \"sphere\"\nshape_slope_rad = 0.1\n"), "");
    EXPECT_NE(refusal("[sample]\nshape = \"plane\"\nshape_radius_m = 1e-7\n"), "");
    EXPECT_NE(refusal("[sample]\nshape = \"sphere\"\nsmoothing_px = 1.0\n"), "");
    EXPECT_NE(refusal("[sample]\nfile = \"map.gsf\"\nshape_radius_m = 1e-7\n"), "");
    EXPECT_EQ(refusal("[sample]\nshape = \"sphere\"\nshape_size_m = 2e-7\n"),
              path + ": [sample]: shape_size_m must be at most 1.25 radii of a sphere or 1.75 of a "
                     "cylinder");
    EXPECT_NE(refusal("[sample]\nshape = \"plane\"\nshape_slope_rad = 1.5\n"), "");
    EXPECT_NE(refusal("[sample]\nshape = \"cylinder\"\nshape_radius_m = nan\n"), "");
}

TEST_F(SceneFile, ComesBackTheSameFromItsOwnText) {
    SceneDescription scene = defaultScene();
    scene.sample.file = "/somewhere/map.gsf";
    scene.sample.channel = "Height \"measured\"";
    scene.sample.material.elastic.youngsModulus = 1.0 / 3.0 * 1e9;
    scene.truth.stiffness = 13.123456789012345;
    scene.probe.mountTilt = 0.1;
    scene.probe.setBack = 5e-6;
    scene.probe.qualityFactor = 250.0;
    scene.detector.invOls = 42e-9;
    scene.detector.lateralCrossTalk = -0.02;
    scene.truth.temperature = 296.15;
    scene.sample.imagingTipRadius = 8e-9;
    scene.sample.erode = true;
    scene.choices.law = ContactLaw::Hertz;
    scene.choices.deformation = DeformationModel::HalfSpace;
    scene.choices.closestPointSearch = SearchEffort::Local;
    scene.choices.decoupling = DecouplingModel::Planar;
    scene.choices.mountTilt = false;
    scene.choices.torsion = true;
    scene.tolerance = 0.125;
    scene.uncertainty.enabled = false;
    scene.uncertainty.thermalStiffness = true;
    for (const UncertaintyRow& row : kEnumTable<UncertaintyInput>) {
        if (row.deviation != nullptr) {
            scene.uncertainty.*row.deviation *= 0.7;
        }
    }
    scene.settings.coupling = {.stiffness = 1e3 / 3.0, .damping = 2.5, .proxyDamping = 3.0};
    scene.settings.governor = {
        .maxForce = 10.0 / 3.0, .engageTime = 0.7, .maxDeviceSpeed = 1.1, .deadManButton = 3};
    scene.settings.clutchButton = 1;
    scene.settings.trialButton = 2;
    scene.settings.guide = {.kind = FixtureKind::Line,
                            .point = {1e-9 / 3.0, 2e-9, -3e-9},
                            .axis = Vector3(1.0, 2.0, 3.0).normalized(),
                            .stiffness = 300.0,
                            .damping = 0.3,
                            .forceLimit = 2.0,
                            .captureDistance = 30e-9 / 7.0};
    const std::string text = sceneText(scene);
    const SceneDescription again = readScene(write("again.toml", text));
    EXPECT_EQ(sceneText(again), text);
    EXPECT_EQ(again.settings.clutchButton, 1);
    EXPECT_EQ(again.settings.trialButton, 2);
    EXPECT_EQ(again.settings.guide, scene.settings.guide);
    EXPECT_EQ(again.sample.channel, scene.sample.channel);
    EXPECT_EQ(again.sample.material.elastic.youngsModulus,
              scene.sample.material.elastic.youngsModulus);
    EXPECT_EQ(again.probe, scene.probe);
    EXPECT_EQ(again.detector, scene.detector);
    EXPECT_EQ(again.truth.temperature, scene.truth.temperature);
    EXPECT_EQ(again.truth.stiffness, scene.truth.stiffness);
    EXPECT_EQ(again.choices.law, scene.choices.law);
    EXPECT_EQ(again.sample.imagingTipRadius, 8e-9);
    EXPECT_TRUE(again.sample.erode);
    EXPECT_EQ(again.choices.deformation, scene.choices.deformation);
    EXPECT_EQ(again.choices.closestPointSearch, scene.choices.closestPointSearch);
    EXPECT_EQ(again.choices.decoupling, scene.choices.decoupling);
    EXPECT_EQ(again.choices.mountTilt, scene.choices.mountTilt);
    EXPECT_EQ(again.choices.torsion, scene.choices.torsion);
    EXPECT_FALSE(again.choices.friction) << "left to the program";
    EXPECT_EQ(again.tolerance, scene.tolerance);
    EXPECT_EQ(again.uncertainty, scene.uncertainty);
    EXPECT_EQ(again.settings.coupling, scene.settings.coupling);
    EXPECT_EQ(again.settings.governor, scene.settings.governor);
}

/// Recordings state every term; those of before one was known do not state that one.
TEST_F(SceneFile, ARecordingOfBeforeBodyAttractionHasNone) {
    const std::string older = "[sample]\nfile = \"map.gsf\"\n[fidelity]\nfriction = \"on\"\n"
                              "torsion = \"off\"\nmount_tilt = \"off\"\n";
    EXPECT_EQ(readScene(write("open.toml", older)).choices.bodyAttraction, std::nullopt);
    const std::string recorded = older + "curvature = \"on\"\n";
    EXPECT_EQ(readScene(write("recorded.toml", recorded)).choices.bodyAttraction, false);
    const std::string newer = recorded + "body_attraction = \"auto\"\n";
    EXPECT_EQ(readScene(write("newer.toml", newer)).choices.bodyAttraction, std::nullopt);
}

TEST_F(SceneFile, NamesScansWhateverTheBytesOfTheirNames) {
    SceneDescription scene = defaultScene();
    for (const char* file : {"/scans/25 \xB5m 50%.gsf", "/scans/a\nb\x1b[31m\"\\.gsf",
                             "/scans/25 µm.gsf", "/scans/file:/100%41.gsf"}) {
        scene.sample.file = file;
        const SceneDescription again = readScene(scratch.write("own.toml", sceneText(scene)));
        EXPECT_EQ(again.sample.file, file);
    }
    EXPECT_EQ(readScene(scratch.write("uri.toml", "[sample]\nfile = \"file:///a/%B5.gsf\"\n"))
                  .sample.file,
              "/a/\xB5.gsf");
}

TEST_F(SceneFile, RefusesAnUnknownKeyByNameAndLine) {
    const std::string message = refusal("[sample]\nfile = \"map.gsf\"\nsmothing_px = 1.0\n");
    EXPECT_NE(message.find("scene.toml"), std::string::npos) << message;
    EXPECT_NE(message.find("line 3"), std::string::npos) << message;
    EXPECT_NE(message.find("'smothing_px'"), std::string::npos) << message;
    EXPECT_NE(refusal("[sample]\nfile=\"m\"\n[samples]\n").find("'samples'"), std::string::npos);
}

TEST_F(SceneFile, RefusesMistakesWithTheirLocation) {
    const char* const sample = "[sample]\nfile = \"map.gsf\"\n";
    const std::pair<std::string, std::string> mistakes[] = {
        {"[sample]\n", "file"},
        {"[sample]\nfile = \"file:///a%4.gsf\"\n", "two digits after each '%'"},
        {"sample = 1\n", "'sample' must be a section"},
        {std::string(sample) + "level = \"flat\"\n", "plane, rows, three_point, facet"},
        {std::string(sample) + "smoothing_px = \"one\"\n", "a number"},
        {std::string(sample) + "smoothing_px = -1\n", "smoothing_px"},
        {std::string(sample) + "smoothing_m = -1e-9\n", "smoothing_m"},
        {std::string(sample) + "smoothing_m = 1e-9\nsmoothing_px = 1\n", "not both"},
        {std::string(sample) + "smoothing_px = nan\n", "smoothing_px"},
        {std::string(sample) + "size_x_m = 1e-6\n", "both sides of the scan"},
        {std::string(sample) + "size_y_m = 1e-6\n", "both sides of the scan"},
        {std::string(sample) + "size_x_m = -1e-6\nsize_y_m = 1e-6\n", "size_x_m"},
        {std::string(sample) + "size_x_m = 1e-6\nsize_y_m = inf\n", "size_y_m"},
        {std::string(sample) + "size_x_m = \"5um\"\nsize_y_m = 1e-6\n", "a number"},
        {std::string(sample) + "z_scale_m = -1\n", "z_scale_m: must lie"},
        {std::string(sample) + "z_scale_m = nan\n", "z_scale_m"},
        {std::string(sample) + "[uncertainty]\nsurface_normal_rad = -0.01\n", "surface_normal_rad"},
        {std::string(sample) + "[probe]\nnormal_deviation_rad = 1.5\n", "surface_normal_rad"},
        {"[sample]\nshape = \"sphere\"\nsize_x_m = 1e-6\nsize_y_m = 1e-6\n", "size_x_m"},
        {std::string(sample) + "erode = true\n", "erode needs imaging_tip_radius_m"},
        {std::string(sample) + "erode = 1\n", "true or false"},
        {std::string(sample) + "imaging_tip_radius_m = -1e-9\n", "imaging_tip_radius_m"},
        {std::string(sample) + "youngs_modulus_pa = -2e9\n", "youngs_modulus_pa"},
        {std::string(sample) + "poisson_ratio = nan\n", "poisson_ratio"},
        {std::string(sample) + "material = \"missing.toml\"\n", "missing.toml"},
        {std::string(sample) + "[probe]\nstiffness_n_m = 1.0\nthickness_m = 1e-6\n", "not both"},
        {std::string(sample) + "[probe]\nstiffness_n_m = -1.0\n", "stiffness_n_m"},
        {std::string(sample) + "[probe]\nlength_m = 0.0\n", "scene.toml"},
        {std::string(sample) + "[truth]\nnoise_seed = -1\n", "noise_seed"},
        {std::string(sample) + "[truth]\ntemperature_k = -1.0\n", "temperature_k"},
        {std::string(sample) + "[physics]\nlaw = \"jkrs\"\n", "split, split_sphere, hertz"},
        {std::string(sample) + "[haptics]\nrate_hz = 1\n", "rate_hz"},
        {std::string(sample) + "[haptics]\ncoupling_stiffness_n_m = -1\n",
         "coupling_stiffness_n_m"},
        {std::string(sample) + "[haptics]\ncoupling_stiffness_n_m = 300\n",
         "proxy_damping_n_s_m above 0"},
        {std::string(sample) + "[haptics]\nmax_force_n = 0\n", "max_force_n"},
        {std::string(sample) + "[haptics]\nengage_s = 0.49\n", "engage_s"},
        {std::string(sample) + "[haptics]\nengage_s = 2.01\n", "engage_s"},
        {std::string(sample) + "[haptics]\nmax_hand_speed_m_s = nan\n", "max_device_speed_m_s"},
        {std::string(sample) + "[haptics]\ndead_man_button = 32\n", "0 to 31, or -1"},
        {std::string(sample) + "[haptics]\ndead_man_button = 0.5\n", "0 to 31, or -1"},
        {std::string(sample) + "[haptics]\ntrial_button = 1\ndead_man_button = 1\n",
         "trial_button must be another one than dead_man_button"},
        {std::string(sample) + "[haptics]\ntrial_button = 0\nclutch_button = 0\n",
         "trial_button must be another one than clutch_button"},
        {"[sample\nfile = 1", "line 1"},
    };
    for (const auto& [text, expected] : mistakes) {
        EXPECT_NE(refusal(text).find(expected), std::string::npos)
            << "for:\n"
            << text << "\nsaid: " << refusal(text);
    }
    EXPECT_THROW((void)readScene(scratch.path() / "none.toml"), InputError);
    EXPECT_THROW((void)readScene(scratch.path()), InputError);
}

TEST(ShippedScenes, AllReadAndNameFilesThatAreThere) {
    int scenes = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(test::dataFolder().string() + "/scenes")) {
        const SceneDescription scene = readScene(entry.path());
        EXPECT_TRUE(scene.sample.shape || std::filesystem::exists(scene.sample.file))
            << scene.sample.file;
        ++scenes;
    }
    EXPECT_GE(scenes, 4);
    for (const auto& entry :
         std::filesystem::directory_iterator(test::dataFolder().string() + "/probes")) {
        EXPECT_GT(Cantilever(readProbe(entry.path()).lever).stiffness(), 0.0) << entry.path();
    }
}

TEST_F(SceneFile, AHeightMapGetsTheInstrumentOfTheSceneBefore) {
    SceneDescription before;
    before.sample.file = "other.gsf";
    before.sample.crop = PixelRectangle{};
    before.sample.material.name = "gold";
    before.tip.radius = 33e-9;
    before.zoomHalfWidth = 1e-6;
    const auto map = write("map.gsf", "no scene");
    const SceneDescription scene = sceneFromInput(map, before);
    EXPECT_EQ(scene.sample.file, map.string());
    EXPECT_EQ(scene.sample.crop, std::nullopt);
    EXPECT_EQ(scene.sample.material.name, "gold");
    EXPECT_EQ(scene.tip.radius, 33e-9);
    EXPECT_EQ(scene.zoomHalfWidth, 0.0);
    before.sample.material.maps.friction = MapSource{};
    EXPECT_EQ(sceneFromInput(map, before).sample.material, sceneFromInput(map).sample.material)
        << "the maps are of the other scan, and their largest values of no material";
}

}  // namespace
}  // namespace asperity
