#include "app/exports/OutputName.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"

namespace asperity {

namespace {

constexpr const char* kUsualName = "{file}_{view}_{n}.png";

/// @throw Error for a placeholder that there is not
std::string filled(const std::string& text, const OutputNameParts& parts, int number) {
    std::string name;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] != '{') {
            name += text[at++];
            continue;
        }
        const std::size_t end = text.find('}', at);
        const std::string placeholder =
            text.substr(at, end == std::string::npos ? end : end - at + 1);
        if (placeholder == "{file}") {
            name += parts.file;
        } else if (placeholder == "{view}") {
            name += parts.view;
        } else if (placeholder == "{n}") {
            name += std::to_string(number);
        } else {
            throw Error("'" + placeholder +
                        "' is no placeholder of a name: expected {file}, {view} or {n}");
        }
        at += placeholder.size();
    }
    return name;
}

}  // namespace

std::filesystem::path namedPath(const std::filesystem::path& folder, const std::string& name,
                                const OutputNameParts& parts) {
    const bool counts = name.find("{n}") != std::string::npos;
    for (int number = 1;; ++number) {
        std::filesystem::path path = folder / filled(name, parts, number);
        if (!counts || !isThere(path)) {
            return path;
        }
    }
}

std::filesystem::path filledPath(const std::filesystem::path& out, const OutputNameParts& parts) {
    return namedPath(out.parent_path(), out.filename().string(), parts);
}

std::filesystem::path outputPath(const std::string& out, const OutputNameParts& parts, bool force) {
    std::error_code unknown;
    const bool isFolder = out.ends_with('/') || std::filesystem::is_directory(out, unknown);
    std::filesystem::path path =
        isFolder ? namedPath(out, kUsualName, parts) : filledPath(out, parts);
    requireFree(path, force);
    return path;
}

}  // namespace asperity
