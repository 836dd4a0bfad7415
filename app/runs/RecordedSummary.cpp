#include "app/runs/RecordedSummary.h"

#include "app/program/JsonText.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/NestedText.h"

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

using Json = nlohmann::json;

/// Empty where there is no text.
std::string textAt(const Json& json, const char* place) {
    const Json::json_pointer pointer(place);
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

}  // namespace

std::optional<RecordedProgram> programOf(const std::filesystem::path& folder) {
    for (const char* const name : {run_files::kSummary, run_files::kManifest}) {
        const Json json = readJson(folder / name);
        const std::string version = textAt(json, "/versions/asperity");
        if (!version.empty()) {
            return RecordedProgram{version, textAt(json, "/versions/compiler")};
        }
    }
    return std::nullopt;
}

std::optional<RecordedSummary> readSummary(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / run_files::kSummary;
    if (!isThere(path)) {
        return std::nullopt;
    }
    const std::string text = readFileBytes(path);
    requireParsable(text, NestedSyntax::Json, path.string());
    try {
        return summaryFrom(Json::parse(text));
    } catch (const Json::exception& damage) {
        throw InputError(path.string(), "", std::string("is damaged: ") + damage.what());
    }
}

}  // namespace asperity
