#include "app/recording/RecordingManifest.h"

#include "app/program/JsonText.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

constexpr const char* kRecordingFormat = "asperity recording";
constexpr int kRecordingVersion = 1;

double lengthIn(const nlohmann::json& input, const char* key, const std::filesystem::path& file) {
    const auto length = input.at(key).get<double>();
    if (!(length > 0.0)) {
        throw InputError(file.string(), std::string("input.") + key,
                         "expected the size of a scan in meters, above 0; the file is damaged");
    }
    return length;
}

std::optional<Vector2> sizeIn(const nlohmann::json& input, const std::filesystem::path& file) {
    if (!input.contains("size_x_m")) {
        return std::nullopt;
    }
    return Vector2(lengthIn(input, "size_x_m", file), lengthIn(input, "size_y_m", file));
}

}  // namespace

void writeManifest(const std::filesystem::path& folder, const RecordingManifest& manifest) {
    nlohmann::ordered_json input{{"sha256", manifest.sha256}};
    if (manifest.size) {
        input["size_x_m"] = manifest.size->x();
        input["size_y_m"] = manifest.size->y();
    }
    const nlohmann::ordered_json json{
        {"format", kRecordingFormat},
        {"format_version", kRecordingVersion},
        {"versions", {{"asperity", kVersion}, {"compiler", __VERSION__}}},
        {"input", input},
        {"complete", manifest.complete},
        {"recovered", manifest.recovered}};
    constexpr int kIndent = 2;
    OutputFile file(folder / run_files::kManifest);
    file.stream() << json.dump(kIndent) << '\n';
    manifest.complete ? file.commitToDisk() : file.commit();
}

std::optional<RecordingManifest> readManifest(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / run_files::kManifest;
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) {
        return std::nullopt;
    }
    const nlohmann::json json = requiredJson(path);
    try {
        if (json.at("format") == kRecordingFormat &&
            json.at("format_version") == kRecordingVersion) {
            return RecordingManifest{.sha256 = json.at("input").at("sha256").get<std::string>(),
                                     .size = sizeIn(json.at("input"), path),
                                     .complete = json.at("complete").get<bool>(),
                                     .recovered = json.at("recovered").get<bool>()};
        }
    } catch (const nlohmann::json::exception&) {  // as of another version
    }
    throw InputError(path.string(), "", "expected the manifest of a recording, format version 1");
}

}  // namespace asperity
