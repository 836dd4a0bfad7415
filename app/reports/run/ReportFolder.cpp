#include "app/reports/run/ReportFolder.h"

#include "app/program/JsonText.h"
#include "app/runs/RunFolder.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace asperity {

namespace {

const char* const kFiles = "files";

std::vector<std::string> filesOf(const std::vector<std::string>& pages) {
    std::vector<std::string> files;
    for (const std::string& page : pages) {
        files.push_back(page + ".html");
        files.push_back(page + ".pdf");
    }
    return files;
}

/// A list may have been changed: nothing but pages of this folder is ever removed.
bool isPage(const std::string& name) {
    const std::filesystem::path path = name;
    const bool isBare = path.filename() == path && !name.empty();
    return isBare && (path.extension() == ".html" || path.extension() == ".pdf");
}

/// Files of the report that is there; none where there is no list, or one that cannot be read.
std::vector<std::string> earlierFiles(const std::filesystem::path& folder) {
    const nlohmann::json list = readJson(folder / kReportList);
    std::vector<std::string> files;
    if (!list.is_object() || !list.contains(kFiles) || !list[kFiles].is_array()) {
        return files;
    }
    for (const nlohmann::json& name : list[kFiles]) {
        if (name.is_string() && isPage(name.get<std::string>())) {
            files.push_back(name.get<std::string>());
        }
    }
    return files;
}

}  // namespace

FolderContent reportContent(const std::filesystem::path& folder,
                            const std::vector<std::string>& pages) {
    FolderContent content{.marks = {kReportList}, .own = {}, .guarded = {}};
    for (const std::vector<std::string>& files : {filesOf(pages), earlierFiles(folder)}) {
        for (const std::string& name : files) {
            if (std::ranges::find(content.own, name) == content.own.end()) {
                content.own.push_back(name);
            }
        }
    }
    return content;
}

void writeReportList(const std::filesystem::path& folder, const std::vector<std::string>& pages) {
    writeTextFile(folder / kReportList, jsonText(nlohmann::json{{kFiles, filesOf(pages)}}) + '\n');
}

}  // namespace asperity
