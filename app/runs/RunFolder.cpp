#include "app/runs/RunFolder.h"

#include "app/program/JsonText.h"
#include "app/program/LoadedScene.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/scene/SceneFile.h"
#include "core/probe/BodySum.h"
#include "core/scene/BelievedModel.h"
#include "core/uncertainty/CycleBudgets.h"
#include "core/words/BudgetWords.h"
#include "core/words/ModelWords.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <toml++/toml.h>
#include <utility>

namespace asperity {

namespace {

std::vector<std::string> without(std::vector<std::string> names,
                                 const std::vector<std::string>& others) {
    std::erase_if(names, [&](const std::string& name) {
        return std::ranges::find(others, name) != others.end();
    });
    return names;
}

using Json = nlohmann::json;

/// Empty where there is no text.
std::string textAt(const Json& json, const char* path) {
    const Json::json_pointer pointer(path);
    return json.is_object() && json.contains(pointer) && json[pointer].is_string()
               ? json[pointer].get<std::string>()
               : std::string();
}

RecordedTerm termFrom(const Json& term) {
    return {.name = term.value("term", ""),
            .on = term.value("on", false),
            .overruled = term.value("overruled", false),
            .effect = term.value("effect", 0.0),
            .why = term.value("why", "")};
}

RecordedSummary summaryFrom(const Json& summary) {
    RecordedSummary recorded;
    const Json input = summary.value("input", Json::object());
    recorded.notes = input.value("notes", std::vector<std::string>());
    const Json model = summary.value("model", Json::object());
    for (const Json& term : model.value("terms", Json::array())) {
        recorded.terms.push_back(termFrom(term));
    }
    return recorded;
}

std::optional<RecordedProgram> programIn(const Json& json) {
    const std::string version = textAt(json, "/versions/asperity");
    return version.empty()
               ? std::nullopt
               : std::optional(RecordedProgram{version, textAt(json, "/versions/compiler")});
}

}  // namespace

const std::vector<std::string>& runFileNames() {
    static const std::vector<std::string> kNames{
        run_files::kInput,       run_files::kTables,
        run_files::kScene,       run_files::kManifest,
        run_files::kMemory,      run_files::kLog,
        run_files::kEnergy,      run_files::kSummary,
        run_files::kDeformation, run_files::kDeformationFields,
        run_files::kOverview,    run_files::kForces};
    return kNames;
}

FolderContent exploredRun() {
    const std::vector<std::string> marks{run_files::kInput, run_files::kTables};
    return {.marks = marks,
            .own = without(runFileNames(), marks),
            .guarded = {run_files::kManifest, run_files::kMemory},
            .needed = {run_files::kScene, run_files::kSummary}};
}

FolderContent convertedRun() {
    FolderContent content = exploredRun();
    content.guarded = runFileNames();
    return content;
}

FolderContent replayedLogs() {
    const std::vector<std::string> logs{run_files::kInput, run_files::kLog};
    return {
        .marks = {logs.front()}, .own = {logs.back()}, .guarded = without(runFileNames(), logs)};
}

RunRecorder::RunRecorder(const std::filesystem::path& folder,
                         std::shared_ptr<const MaterialField> field)
    : log_(folder / run_files::kLog, std::move(field)), input_(folder / run_files::kInput) {}

void RunRecorder::take(const TickSample& sample) {
    log_.take(sample);
    input_.take(sample);
}

void RunRecorder::flush() {
    log_.flush();
    input_.flush();
}

void RunRecorder::sync() const {
    log_.sync();
    input_.sync();
}

void RunRecorder::close() {
    log_.close();
    input_.close();
}

bool isThere(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::exists(std::filesystem::symlink_status(path, unknown));
}

bool isSceneOfRun(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path();
    return file.filename() == run_files::kScene &&
           (isThere(folder / run_files::kInput) || isThere(folder / run_files::kTables));
}

void requireFree(const std::filesystem::path& file, bool force) {
    if (!force && isThere(file)) {
        throw Error(file.string() +
                    ": is there already; name another file, or replace it with --force");
    }
}

void requireOutside(const std::filesystem::path& input, const std::filesystem::path& file) {
    std::error_code unknown;
    const std::filesystem::path named = std::filesystem::absolute(file, unknown);
    for (std::filesystem::path part : {named, std::filesystem::weakly_canonical(named, unknown)}) {
        for (; part.has_relative_path(); part = part.parent_path()) {
            if (std::filesystem::equivalent(input, part, unknown)) {
                throw Error(file.string() + ": this is an input, or lies in the folder of one; "
                                            "name a file elsewhere");
            }
        }
    }
}

void writeTextFile(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path);
    file.stream() << text;
    file.commit();
}

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kLeftOut = "terms_left_out";

OrderedJson sceneJson(const SceneDescription& scene) {
    std::ostringstream text;
    text << toml::json_formatter(toml::parse(sceneText(scene)));
    return OrderedJson::parse(text.str());
}

OrderedJson inputJson(const LoadedScene& loaded) {
    const BSplineSurface& surface = loaded.scene.surface;
    return {{"file", pathText(loaded.scene.description.sample.file)},
            {"sha256", loaded.sha256},
            {"format", loaded.format},
            {"channel", loaded.scene.description.sample.channel},
            {"columns", surface.grid().columns},
            {"rows", surface.grid().rows},
            {"size_x_m", surface.sizeX()},
            {"size_y_m", surface.sizeY()},
            {"removed_slope_x", loaded.scene.removedPlane.slopeX},
            {"removed_slope_y", loaded.scene.removedPlane.slopeY},
            {"height_noise_m", loaded.scene.heightNoise},
            {"notes", notesOn(loaded)},
            {"provenance", provenanceJson(loaded.provenance)}};
}

OrderedJson termJson(const TermNeed& need, const RequiredTerms& needs) {
    return {{"term", nameOf(need.term)},
            {"on", need.on},
            {"overruled", need.overruled},
            {"why", whyOf(need, needs)},
            {"effect", need.effect},
            {"quantity", isOfSurface(need.term) ? "displacement" : nameOf(need.quantity)}};
}

/// Times are not in it: a run's summary is the same on every machine.
OrderedJson modelJson(const RequiredTerms& needs) {
    OrderedJson terms = OrderedJson::array();
    for (const TermNeed& need : needs.terms) {
        terms.push_back(termJson(need, needs));
    }
    OrderedJson model = {{"tolerance", needs.tolerance},
                         {"setpoint_n", needs.setpoint},
                         {"error", nullptr},
                         {"terms", terms}};
    if (needs.measured) {
        const QuantityErrors total = needs.totalErrors();
        const JudgedQuantity worst = total.worstQuantity();
        model["error"] = total.worst();
        model["error_quantity"] = nameOf(worst);
        model["error_left_out"] = needs.wholeErrors[worst];
        model["error_law"] = needs.lawErrors[worst];
        OrderedJson errors = OrderedJson::object();
        for (const JudgedQuantity quantity : kValues<JudgedQuantity>) {
            errors[keyOf(quantity)] = total[quantity];
        }
        model["errors"] = errors;
    }
    return model;
}

OrderedJson vectorJson(const Vector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

OrderedJson stateJson(const TickSample& sample) {
    const TickOutput& out = sample.output;
    return {{"time_s", sample.time},
            {"base_m", vectorJson(out.base.position)},
            {"tip_m", vectorJson(out.tip)},
            {"model_normal_force_n", out.model.contact.force},
            {"model_force_n", vectorJson(out.model.force)},
            {"estimated_force_n", vectorJson(out.estimate.force)},
            {"indentation_m", out.model.contact.indentation},
            {"contact_radius_m", out.model.contact.contactRadius},
            {"state", keyOf(out.region())},
            {"flags", validityText(out.flags)}};
}

OrderedJson optionalState(const std::optional<TickSample>& sample) {
    return sample ? stateJson(*sample) : OrderedJson(nullptr);
}

/// The half-space's view of a state; null where the scene does not ask for it.
OrderedJson halfSpaceJson(const Scene& scene, const std::optional<TickSample>& sample) {
    if (!sample || scene.model.deformation != DeformationModel::HalfSpace) {
        return nullptr;
    }
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, sample->output.model);
    return {{"valid", answer.valid()},
            {"remark", sentenceOf(answer)},
            {"normal_force_n", answer.force},
            {"law_normal_force_n", sample->output.model.normalForce},
            {"contact_radius_m", answer.contactRadius}};
}

/// Attraction by the sample beside the contact, which the contact law leaves out, and what the
/// model has of it; null where the state has no contact on a height field.
OrderedJson bodyAttractionJson(const Scene& scene, const std::optional<TickSample>& sample) {
    if (!sample || scene.shape || !(sample->output.model.contact.contactRadius > 0.0)) {
        return nullptr;
    }
    const TipState& state = sample->output.model;
    const BodyAttraction beside = bodyAttraction(scene.surface, scene.belief, state);
    return {{"force_n", beside.force},
            {"share_of_pull_off", beside.share},
            {"in_model_n", state.body.at(state.contact.indentation)}};
}

/// A jump of the model between two states; null when there was none.
OrderedJson jumpJson(const std::optional<TickSample>& before,
                     const std::optional<TickSample>& after) {
    if (!before || !after) {
        return nullptr;
    }
    return {{"before", stateJson(*before)},
            {"after", stateJson(*after)},
            {"energy_lost_j", after->output.model.contact.energyLost}};
}

/// The last jump off, and when signals and model last held the tip both.
OrderedJson pullOffJson(const RunEvents& events) {
    OrderedJson json = jumpJson(events.beforePullOff, events.pullOff);
    if (!json.is_null()) {
        json["last_hold"] = optionalState(events.lastHold);
    }
    return json;
}

OrderedJson readingJson(const std::optional<Reading>& reading) {
    return reading ? OrderedJson(reading->value) : OrderedJson(nullptr);
}

OrderedJson sigmaJson(const std::optional<Reading>& reading) {
    return reading ? OrderedJson(reading->sigma) : OrderedJson(nullptr);
}

/// Returns the key of what leaves most of a result open, an input or the terms left out; null where
/// nothing does or that is not known.
OrderedJson dominantJson(const Budget& budget) {
    if (budget.isMostLeftOut()) {
        return kLeftOut;
    }
    const std::optional<UncertaintyInput> dominant = budget.dominant();
    return dominant ? OrderedJson(keyOf(*dominant)) : OrderedJson(nullptr);
}

/// Joins what there is to say of a reading; empty: nothing.
std::string noteOn(const CycleBudget& one, double tolerance) {
    const std::string unknown = unknownText(one.budget, one.name);
    const std::string resolution = resolutionText(one.budget, one.name, tolerance);
    return unknown + (unknown.empty() || resolution.empty() ? "" : "; ") + resolution;
}

/// A deviation that is not known is null.
OrderedJson budgetJson(const CycleBudget& one, double tolerance) {
    const Budget& budget = one.budget;
    OrderedJson shares = OrderedJson::object();
    for (const UncertaintyInput input : kValues<UncertaintyInput>) {
        shares[keyOf(input)] = budget.share(input);
    }
    return {{"text", budgetText(budget, one.unit)},
            {"value", budget.value},
            {"shift", budget.shift},
            {"noise_sigma", budget.noise},
            {"model_sigma", budget.model()},
            {kLeftOut, budget.isLeftOutKnown() ? OrderedJson(budget.leftOut) : nullptr},
            {"dominant", dominantJson(budget)},
            {"shares", shares},
            {"note", noteOn(one, tolerance)}};
}

/// By the keys of the readings; null where the scene has them off.
OrderedJson budgetsJson(const Scene& scene, const ContactCycle& cycle) {
    if (!scene.description.uncertainty.enabled) {
        return nullptr;
    }
    OrderedJson json = OrderedJson::object();
    for (const CycleBudget& budget : cycleBudgets(scene, cycle)) {
        json[budget.key] = budgetJson(budget, scene.description.tolerance);
    }
    return json;
}

/// Returns the results of a cycle's force-distance curve; null: it has no such one.
OrderedJson cycleJson(const Scene& scene, const ContactCycle& cycle) {
    const std::optional<Reading> pullOff = cycle.pullOffForce();
    return {{"touch_s", cycle.touchTime},
            {"off_s", cycle.complete() ? OrderedJson(cycle.offTime) : OrderedJson(nullptr)},
            {"x_m", cycle.position.x()},
            {"y_m", cycle.position.y()},
            {"snap_in_force_n", readingJson(cycle.snapIn)},
            {"snap_in_force_sigma_n", sigmaJson(cycle.snapIn)},
            {"snap_in_distance_m",
             cycle.snapIn ? OrderedJson(cycle.snapInBaseDistance.value) : OrderedJson(nullptr)},
            {"snap_in_distance_sigma_m",
             cycle.snapIn ? OrderedJson(cycle.snapInBaseDistance.sigma) : OrderedJson(nullptr)},
            {"pull_off_force_n", readingJson(pullOff)},
            {"pull_off_force_sigma_n", sigmaJson(pullOff)},
            {"adhesion_work_j", readingJson(cycle.workOfAdhesion())},
            {"hysteresis_j", readingJson(cycle.closedHysteresis())},
            {"area_sigma_j", cycle.areaSigma},
            {"contact_stiffness_n_m", readingJson(cycle.stiffness)},
            {"max_force_n", readingJson(cycle.maxForce)},
            {"max_force_sigma_n", sigmaJson(cycle.maxForce)},
            {"max_indentation_m", readingJson(cycle.maxIndentation)},
            {"max_indentation_sigma_m", sigmaJson(cycle.maxIndentation)},
            {"contacts", cycle.contacts},
            {"interrupted", cycle.interrupted},
            {"uncertainty", budgetsJson(scene, cycle)}};
}

OrderedJson cyclesJson(const Scene& scene, const std::vector<ContactCycle>& cycles) {
    OrderedJson list = OrderedJson::array();
    for (const ContactCycle& cycle : cycles) {
        list.push_back(cycleJson(scene, cycle));
    }
    return list;
}

OrderedJson flagsJson(const RunEvents& events) {
    OrderedJson flags = OrderedJson::object();
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        flags[kValidityTraits.at(i).key] = events.flagged.at(i);
    }
    return flags;
}

}  // namespace

std::string runSummary(const LoadedScene& loaded, const RunEvents& events) {
    const OrderedJson summary{
        {"versions", {{"asperity", kVersion}, {"compiler", __VERSION__}}},
        {"input", inputJson(loaded)},
        {"scene", sceneJson(settled(loaded.scene.description, loaded.scene.model))},
        {"model", modelJson(loaded.needs)},
        {"statistics",
         {{"ticks", events.ticks},
          {"tick_rate_hz", loaded.scene.description.tickRate},
          {"largest_model_force_n", events.largestForce},
          {"largest_estimated_force_n", events.largestEstimatedForce},
          {"ticks_flagged", flagsJson(events)},
          {"ticks_faulted", events.faults}}},
        {"cycles", cyclesJson(loaded.scene, events.cycles)},
        {"snap_in", jumpJson(events.beforeSnapIn, events.snapIn)},
        {"pull_off", pullOffJson(events)},
        {"largest_indentation", optionalState(events.deepest)},
        {"largest_indentation_half_space", halfSpaceJson(loaded.scene, events.deepest)},
        {"strongest_attraction", optionalState(events.strongestPull)},
        {"strongest_attraction_body", bodyAttractionJson(loaded.scene, events.strongestPull)}};
    return jsonText(summary) + '\n';
}

RunRecord readRecord(const std::filesystem::path& folder) {
    RunRecord record;
    const std::filesystem::path path = folder / run_files::kSummary;
    if (isThere(path)) {
        const Json summary = requiredJson(path);
        try {
            record.summary = summaryFrom(summary);
        } catch (const Json::exception& damage) {
            throw InputError(path.string(), "", std::string("is damaged: ") + damage.what());
        }
        record.program = programIn(summary);
    }
    if (!record.program) {
        record.program = programIn(readJson(folder / run_files::kManifest));
    }
    return record;
}

}  // namespace asperity
