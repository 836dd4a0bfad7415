#include "app/program/DataFolder.h"
#include "app/reports/run/RunSections.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/probe/CantileverModes.h"
#include "core/scene/SampleMaterials.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneFields.h"
#include "core/words/ModelWords.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// Shortens a file's own description, which may be long.
std::string shortened(const std::string& text) {
    constexpr std::size_t kMax = 400;
    return text.size() <= kMax ? text : std::string(utf8Start(text, kMax)) + " …";
}

void addFact(PageTable& facts, const char* name, const std::string& value) {
    facts.rows.push_back({{name}, {shortened(value)}});
}

PageTable factTable() {
    return {.columns = {{"quantity"}, {"value"}}, .rows = {}, .hasTitles = false};
}

std::string pair(double x, double y) { return formatSi(x, "m") + " × " + formatSi(y, "m"); }

std::string positionText(const Vector3& position) {
    return "x = " + formatSi(position.x(), "m") + ", y = " + formatSi(position.y(), "m");
}

std::string levelingText(const Scene& scene) {
    std::string text;
    for (const std::string& note : levelingNotes(scene.removedBySteps)) {
        const std::size_t name = note.find(": ");  // "leveling, step 1 of 2: "
        text +=
            (text.empty() ? "" : "; ") + (name == std::string::npos ? note : note.substr(name + 2));
    }
    return text;
}

std::string smoothingText(const SampleDescription& sample) {
    if (sample.smoothingLength > 0.0) {
        return "Gaussian, standard deviation " + formatSi(sample.smoothingLength, "m");
    }
    const double pixels = sample.smoothingPixels.value_or(0.0);
    return pixels > 0.0 ? formatted("Gaussian, standard deviation %.3g pixels", pixels)
                        : std::string("none");
}

void addScan(PageTable& facts, const ReportedRun& run) {
    const LoadedScene& loaded = run.loaded;
    const SampleDescription& sample = loaded.scene.description.sample;
    addFact(facts, "File",
            run.bundle ? run.scan + " in the bundle " + run.folder.filename().string() : run.scan);
    addFact(facts, "Format", loaded.format);
    addFact(facts, "SHA-256", loaded.sha256);
    addFact(facts, "Channel", sample.channel);
    const BSplineSurface& surface = loaded.scene.surface;
    const BSplineSurface::Grid& grid = surface.grid();
    addFact(facts, "Size", pair(surface.sizeX(), surface.sizeY()));
    addFact(facts, "Pixels",
            std::to_string(grid.columns) + " × " + std::to_string(grid.rows) + ", each " +
                pair(grid.pitchX, grid.pitchY) + "; " + std::to_string(loaded.filledPixels) +
                " without data, filled in");
    if (const auto& crop = sample.crop) {
        addFact(facts, "Part of the scan",
                formatted("from column %d, row %d", crop->column, crop->row));
    }
    addFact(facts, "Leveling", levelingText(loaded.scene));
    addFact(facts, "Smoothing", smoothingText(sample));
    addFact(facts, "Height noise", formatSi(loaded.scene.heightNoise, "m"));
}

void addPositions(PageTable& facts, const RunEvents& events) {
    if (!events.cycles.empty()) {
        const ContactCycle& first = events.cycles.front();
        addFact(facts, first.fromStart ? "In contact from the start at" : "First contact",
                positionText({first.position.x(), first.position.y(), 0.0}));
        addFact(facts, "Deepest contact", positionText(events.deepest->output.model.tip));
    } else if (events.deepest) {
        addFact(facts, "Nearest to the sample", positionText(events.deepest->output.model.tip));
    }
}

PageTable provenanceTable(const std::vector<Provenance>& provenance) {
    PageTable table{.columns = {{"What"}, {"Value"}, {"Where from"}}, .rows = {}};
    for (const Provenance& entry : provenance) {
        table.rows.push_back({{entry.what}, {shortened(entry.value)}, {shortened(entry.source)}});
    }
    return table;
}

}  // namespace

void addSample(PageContent& page, const ReportedRun& run) {
    const SampleDescription& sample = run.loaded.scene.description.sample;
    PageTable facts = factTable();
    if (sample.shape) {
        addFact(facts, "Shape", sampleName(sample));
    } else {
        addScan(facts, run);
    }
    addFact(facts, "Imaging tip", imagingTipWords(run.loaded.scene));
    addFact(facts, "Material", sample.material.name);
    addPositions(facts, run.history.events());
    page.addHeading("Sample");
    page.addTable(std::move(facts));
    page.addPicture({run.overview, "The sample in 3-D, with the tip position",
                     "Positions count from the lower left corner of the scan, x to the right, y up "
                     "in the image."});
    if (!run.loaded.provenance.empty()) {
        page.addHeading("Where the numbers of the scan come from");
        page.addTable(provenanceTable(run.loaded.provenance));
    }
}

namespace {

/// Its name may be another: a scene may say that the material is assumed.
std::string materialFileOf(const SampleMaterial& material) {
    for (const std::filesystem::path& file : dataFiles("materials")) {
        SampleMaterial shipped = readMaterialFile(file);
        shipped.name = material.name;
        if (shipped == material) {
            return file.stem().string();
        }
    }
    return {};
}

/// A scene file keeps a thickness to the last bit, but a stiffness gives one that is computed.
bool isNear(double value, double other) {
    constexpr double kRounding = 1e-12;
    return std::abs(value - other) <= kRounding * std::abs(other);
}

bool isSameLever(CantileverGeometry lever, const CantileverGeometry& other) {
    if (isNear(lever.thickness, other.thickness)) {
        lever.thickness = other.thickness;
    }
    return lever == other;
}

std::string probeFileOf(const SceneDescription& scene) {
    for (const std::filesystem::path& file : dataFiles("probes")) {
        const ProbeDescription shipped = readProbe(file);
        if (isSameLever(scene.probe, shipped.lever) && scene.detector == shipped.detector) {
            return file.stem().string();
        }
    }
    return {};
}

bool isSame(const SceneValue& value, const SceneValue& other) {
    const auto* const number = std::get_if<double>(&value);
    const auto* const otherNumber = std::get_if<double>(&other);
    return number != nullptr && otherNumber != nullptr ? isNear(*number, *otherNumber)
                                                       : value == other;
}

/// Possible sources of the values of a scene, as far as a run knows: it keeps every value, not
/// where it was written.
class ParameterSources {
public:
    /// Reads the library that comes with the program. @throw InputError
    explicit ParameterSources(const SceneDescription& scene)
        : scene_(scene)
        , defaults_(defaultScene())
        , material_(materialFileOf(scene.sample.material))
        , probe_(probeFileOf(scene)) {}

    /// For people: "library: silicon_14_n_m", "default", "scene".
    [[nodiscard]] std::string sourceOf(const SceneField& field) const {
        const std::string key = field.key;
        // No probe file has it.
        const bool isOfEstimator = key == "signal_noise_rad";
        if (field.group == SceneGroup::Material && !material_.empty()) {
            return "library: " + material_;
        }
        if (field.group == SceneGroup::Probe && !probe_.empty() && !isOfEstimator) {
            return "library: " + probe_;
        }
        return isSame(field.get(scene_), field.get(defaults_)) ? "default" : "scene";
    }

private:
    const SceneDescription& scene_;
    SceneDescription defaults_;
    std::string material_;  ///< of the library, with all of the scene's values; empty: none
    std::string probe_;     ///< the same
};

/// Meaning of zero for a key.
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

/// Lists what the keys of [truth] give the instrument, where the model believes otherwise.
PageTable truthTable(const SceneDescription& scene) {
    SceneDescription believed = scene;
    believed.truth.material = scene.sample.material;
    believed.truth.stiffness = Cantilever(scene.probe).stiffness();
    believed.truth.signalNoise = scene.signalSigma;
    believed.truth.curve.clear();
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
    if (!scene.description.truth.curve.empty()) {
        page.addParagraph("The instrument plays a recorded force curve, with its own lever and "
                          "noise; what else is said of it does not act:",
                          PageTone::Caution);
        page.addTable(std::move(truth));
        return;
    }
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

namespace {

/// Without a summary: as the scene has them, where all are settled.
std::vector<RecordedTerm> settledTerms(const RequiredTerms& needs) {
    std::vector<RecordedTerm> terms;
    for (const TermNeed& need : needs.terms) {
        terms.push_back({.name = nameOf(need.term),
                         .on = need.on,
                         .overruled = true,
                         .effect = need.effect,
                         .why = whyOf(need, needs)});
    }
    return terms;
}

std::string effectText(double effect) {
    const double percent = 100.0 * effect;
    return formatted(percent < 99.5 ? "%.2g\u00A0%%" : "%.0f\u00A0%%", percent);
}

PageTable termTable(const std::vector<RecordedTerm>& terms) {
    PageTable table{
        .columns = {{"Term"}, {"In the model"}, {"Effect", true}, {"Decided by"}, {"Why"}},
        .rows = {}};
    for (const RecordedTerm& term : terms) {
        table.rows.push_back({{term.name},
                              {term.on ? "yes" : "left out"},
                              {effectText(term.effect)},
                              {term.overruled ? "scene" : "fit"},
                              {term.why}});
    }
    return table;
}

}  // namespace

void addModel(PageContent& page, const ReportedRun& run) {
    const LoadedScene& loaded = run.loaded;
    const bool isRecorded = run.summary && !run.summary->terms.empty();
    page.addHeading("Model");
    page.addParagraph(std::string("Contact law: ") + nameOf(loaded.scene.model.law) +
                      ". Model: " + nameOf(loaded.scene.model) + ".");
    page.addList(run.summary ? run.summary->notes : notesOn(loaded));
    page.addTable(termTable(isRecorded ? run.summary->terms : settledTerms(loaded.needs)));
    page.addParagraph(
        "Effect: what leaving the term out changes of the quantity that it changes most, in "
        "sampled runs and force curves, as a share of that; of a position as a share of the base's "
        "travel from setpoint to pull-off. Fit: the term is in where that exceeds the tolerance "
        "of the scene. Scene: it decides itself.");
    if (!isRecorded) {
        page.addParagraph(
            "The run has no summary with the reasons: these are the choices that its scene keeps.");
    }
}

}  // namespace asperity
