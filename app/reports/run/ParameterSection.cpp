#include "app/reports/run/ParameterSection.h"

#include "app/reports/run/ParameterSource.h"
#include "core/SiFormat.h"
#include "core/scene/SampleHardness.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneFields.h"
#include "core/words/FieldWords.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

/// What zero means of a key.
struct ZeroWords {
    std::string_view key;
    const char* words;
};

constexpr std::array<ZeroWords, 6> kZeros{{{"sample.film_thickness_m", "none: a half-space"},
                                           {"sample.work_of_adhesion_j_m2", "0 mJ/m²: no adhesion"},
                                           {"probe.inv_ols_m_v", "not known"},
                                           {"probe.lateral_sensitivity_rad_v", "not known"},
                                           {"physics.meniscus_tension_n_m", "0 mN/m: no meniscus"},
                                           {"truth.temperature_k", "0 K: no thermal noise"}}};

/// Keys that say nothing of this scene, or that another section has.
constexpr std::array<std::string_view, 6> kLeftOut{"sample.name",
                                                   "physics.law",
                                                   "probe.cross_talk_vertical",
                                                   "probe.cross_talk_lateral",
                                                   "probe.set_back_m",
                                                   "probe.density_kg_m3"};

std::string textOf(const SceneField& field, const SceneDescription& scene) {
    const SampleMaterial& material = scene.sample.material;
    if (nameOf(field) == "sample.hardness_pa" &&
        hardnessOf(material).source != HardnessSource::Stated) {
        return hardnessText(material);
    }
    const SceneValue value = field.get(scene);
    const auto* const zero = std::ranges::find(kZeros, nameOf(field), &ZeroWords::key);
    const auto* const number = std::get_if<double>(&value);
    const bool isZero = number != nullptr && *number == 0.0;
    return isZero && zero != kZeros.end() ? zero->words : valueText(field, scene);
}

bool isShown(const SceneField& field, const SceneDescription& scene) {
    if (std::ranges::find(kLeftOut, nameOf(field)) != kLeftOut.end()) {
        return false;
    }
    if (nameOf(field) == "physics.meniscus_angle_rad" ||
        nameOf(field) == "physics.meniscus_range_m") {
        return scene.meniscus.surfaceTension > 0.0;
    }
    switch (field.group) {
    case SceneGroup::Material:
    case SceneGroup::Tip:
    case SceneGroup::Probe:
    case SceneGroup::Physics:
    case SceneGroup::Approach:
        return true;
    default:
        return false;
    }
}

std::string captionOf(const SceneField& field) {
    const char* const group = field.group == SceneGroup::Probe      ? "Lever"
                              : field.group == SceneGroup::Material ? "Sample"
                                                                    : nameOf(field.group);
    return std::string(group) + ": " + field.words.caption;
}

PageTable parameterTable(const Scene& scene) {
    const SceneDescription& description = scene.description;
    const ParameterSources sources(description);
    PageTable table{.columns = {{"Parameter"}, {"Value"}, {"Source"}}, .rows = {}};
    for (const SceneField& field : sceneFields()) {
        const std::string text = isShown(field, description) ? textOf(field, description) : "";
        if (!text.empty()) {  // an empty one is a file that the scene does not have
            table.rows.push_back({{captionOf(field)}, {text}, {sources.sourceOf(field)}});
        }
    }
    table.rows.push_back({{"Reduced modulus of tip and sample"},
                          {formatSi(scene.belief.contact.pair().reducedModulus, "Pa")},
                          {"from both materials"}});
    const bool isDefaultRate = description.tickRate == defaultScene().tickRate;
    table.rows.push_back({{"Ticks per second"},
                          {formatSi(description.tickRate, "Hz")},
                          {isDefaultRate ? "default" : "scene"}});
    return table;
}

/// What the instrument is told of by the keys of [truth], as far as the model believes otherwise.
PageTable truthTable(const SceneDescription& scene) {
    SceneDescription believed = scene;
    believed.truth.material = scene.sample.material;
    believed.truth.stiffness = Cantilever(scene.probe).stiffness();
    believed.truth.signalNoise = scene.signalSigma;
    PageTable table{.columns = {{"Of the simulated instrument"}, {"True"}, {"Believed"}},
                    .rows = {}};
    for (const SceneField& field : sceneFields()) {
        const std::string isTrue = textOf(field, scene);
        const std::string isBelieved = textOf(field, believed);
        if (field.group == SceneGroup::Truth && isTrue != isBelieved) {
            table.rows.push_back({{field.words.caption}, {isTrue}, {isBelieved}});
        }
    }
    return table;
}

}  // namespace

void addParameters(PageContent& page, const Scene& scene) {
    page.addHeading("Parameters");
    page.addTable(parameterTable(scene));
    page.addParagraph(
        "A run keeps every value, but not where it was written. Library: all values of that "
        "material or probe are those that come with the program; default: as in a scene that does "
        "not mention it; scene: neither of both.");
    PageTable truth = truthTable(scene.description);
    if (truth.rows.empty()) {
        page.addParagraph(
            "The instrument is simulated. Its lever, sample and noise are what the model takes "
            "them to be, so that results show errors of the method and of noise, not of wrong "
            "parameters.");
        return;
    }
    page.addParagraph(
        "The instrument is simulated, and differs from what the model takes it to be:",
        PageTone::Caution);
    page.addTable(std::move(truth));
}

}  // namespace asperity
