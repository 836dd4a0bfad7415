#include "app/commands/CurveCases.h"

#include "app/commands/OptionChecks.h"
#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "core/io/scene/SceneFile.h"
#include "core/words/ModelWords.h"

namespace asperity {

namespace {

constexpr double kMinStiffness = 1e-6;       // [N/m]
constexpr double kMaxStiffness = 1e12;       // [N/m]
constexpr double kMinReducedModulus = 1.0;   // [Pa]
constexpr double kMaxReducedModulus = 1e13;  // [Pa]

/// A material by the path of its file or by its name in the data folder.
SampleMaterial findMaterial(const std::string& given) {
    if (std::filesystem::exists(given)) {
        return readMaterialFile(given);
    }
    const std::filesystem::path known = dataFolder() / "materials" / (given + ".toml");
    if (std::filesystem::exists(known)) {
        return readMaterialFile(known);
    }
    std::string names;
    for (const auto& file : dataFiles("materials")) {
        names += (names.empty() ? "" : ", ") + file.stem().string();
    }
    throw InputError(given, "", "expected a material file or one of " + names);
}

std::vector<std::string> lawNames() {
    std::vector<std::string> names{"auto"};
    for (const ContactLaw law : kValues<ContactLaw>) {
        names.emplace_back(keyOf(law));
    }
    return names;
}

/// A tip whose own part of any reduced modulus is below rounding.
constexpr Elastic kRigidTip{.youngsModulus = 1e30, .poissonRatio = 0.0};

/// The material with the modulus that gives this reduced one under a rigid tip: of another modulus,
/// another hardness.
SampleMaterial withReducedModulus(SampleMaterial material, double reducedModulus) {
    const double ratio = material.elastic.poissonRatio;
    material.elastic.youngsModulus = reducedModulus * (1.0 - ratio * ratio);
    material.hardness = 0.0;
    return material;
}

CurveCase caseOf(const SceneDescription& scene, ContactLaw law, const std::string& why,
                 double compliance) {
    const SampleMaterial& material = scene.sample.material;
    const ContactPair pair = contactPair(scene, material);
    return {scene, material, ContactModel(law, pair, contactOptions(scene, material)), compliance,
            why};
}

/// The case of the scene's material, and another for comparison where the law is not the usual one.
void addCases(const SceneDescription& scene, double compliance, std::vector<CurveCase>& cases) {
    checkScene(scene);
    if (scene.sample.material.maps.any()) {
        throw Error("a curve is of one material, and this sample has maps of several: give a "
                    "--material, or take one pixel by `asperity map --region`");
    }
    const LawChoice choice =
        chooseLaw(scene.choices.law, contactPair(scene, scene.sample.material),
                  scene.sample.material.filmThickness, scene.tip.coneHalfAngle);
    cases.push_back(caseOf(scene, choice.law, whyOf(choice), compliance));
    if (!scene.choices.law && choice.law == ContactLaw::SphereSplit) {
        cases.push_back(caseOf(scene, ContactLaw::Split,
                               "for comparison: formally, as for a paraboloid", compliance));
    }
}

CLI::Validator within(double low, double high, const std::string& words) {
    return {[low, high, words](const std::string& text) {
                const double value = std::strtod(text.c_str(), nullptr);
                return value >= low && value <= high ? std::string() : "expected " + words;
            },
            ""};
}

}  // namespace

void addCurveRequest(CLI::App& command, CurveRequest& request) {
    command.add_option("SCENE", request.scene, "scene.toml (default: the default scene)");
    command
        .add_option("--material", request.materials,
                    "material file or the name of one in data/materials; may be given again")
        ->allow_extra_args(false);
    command.add_option("--law", request.law, "contact law (default: as in the scene, or auto)")
        ->check(CLI::IsMember(lawNames()));
    command.add_option("--radius", request.radius, "tip radius [m]")
        ->check(finiteNumber())
        ->check(within(kMinTipRadius, kMaxTipRadius, "1e-12 to 1 m"));
    command
        .add_option("--reduced-modulus", request.modulus,
                    "reduced modulus E* of tip and sample [Pa], in place of those of the materials")
        ->check(finiteNumber())
        ->check(within(kMinReducedModulus, kMaxReducedModulus, "1 to 1e13 Pa"));
    command
        .add_option("--stiffness", request.stiffness,
                    "stiffness of the lever along the normal [N/m]")
        ->check(finiteNumber())
        ->check(within(kMinStiffness, kMaxStiffness, "1e-6 to 1e12 N/m"));
}

std::vector<CurveCase> curveCases(const CurveRequest& request) {
    SceneDescription scene = request.scene.empty() ? defaultScene() : sceneFromInput(request.scene);
    scene.tip.radius = request.radius > 0.0 ? request.radius : scene.tip.radius;
    if (request.modulus > 0.0) {
        scene.tip.elastic = kRigidTip;
    }
    if (!request.law.empty()) {
        scene.choices.law = fromKey<ContactLaw>(request.law);  // none: "auto"
    }
    const double compliance = request.stiffness > 0.0 ? 1.0 / request.stiffness
                                                      : Cantilever(scene.probe).compliance()(2, 2);
    std::vector<SampleMaterial> materials;
    for (const std::string& given : request.materials) {
        materials.push_back(findMaterial(given));
    }
    if (materials.empty()) {
        materials.push_back(scene.sample.material);
    }
    std::vector<CurveCase> cases;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        scene.sample.material = request.modulus > 0.0
                                    ? withReducedModulus(materials[i], request.modulus)
                                    : materials[i];
        try {
            addCases(scene, compliance, cases);
        } catch (const Error& error) {
            const std::string file =
                request.materials.empty() ? request.scene : request.materials[i];
            if (file.empty()) {
                throw;  // no file's fault
            }
            throw InputError(file, "", error.what());
        }
    }
    return cases;
}

}  // namespace asperity
