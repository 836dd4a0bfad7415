#include "app/exports/ExportView.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <iterator>

namespace asperity {

namespace {

std::string listOf(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) {
        list.append(list.empty() ? "" : ", ").append(word);
    }
    return list;
}

/// The usual one first.
std::vector<std::string> extensionsOf(ExportFormat format) {
    const ExportFormatRow& row = *rowOf(format);
    std::vector<std::string> extensions{std::string(".") + row.key};
    if (row.other != nullptr) {
        extensions.push_back(std::string(".") + row.other);
    }
    return extensions;
}

/// The extensions that a view may be written with.
std::string extensionsOf(ExportView view) {
    std::vector<std::string> all;
    for (const ExportFormat format : formatsOf(view)) {
        std::ranges::move(extensionsOf(format), std::back_inserter(all));
    }
    return listOf(all);
}

/// The usual extensions of a view's formats, of those that all views have or of the others.
std::string usualExtensions(ExportView view, bool ofAll) {
    std::vector<std::string> extensions;
    for (const ExportFormat format : formatsOf(view)) {
        if (std::ranges::all_of(kValues<ExportView>, rowOf(format)->holds) == ofAll) {
            extensions.push_back(extensionsOf(format).front());
        }
    }
    return listOf(extensions);
}

}  // namespace

std::vector<ExportFormat> formatsOf(ExportView view) {
    std::vector<ExportFormat> formats;
    for (const ExportFormatRow& row : kEnumTable<ExportFormat>) {
        if (row.holds(view)) {
            formats.push_back(row.value);
        }
    }
    return formats;
}

ExportFormat formatOf(const std::filesystem::path& file, ExportView view) {
    const std::string extension = lowerCase(file.extension().string());
    for (const ExportFormat format : formatsOf(view)) {
        if (std::ranges::count(extensionsOf(format), extension) > 0) {
            return format;
        }
    }
    throw Error(file.string() + ": the view " + keyOf(view) +
                " is written with one of the extensions " + extensionsOf(view));
}

std::string extensionHelp() {
    std::string help = usualExtensions(kValues<ExportView>.front(), true);
    std::string before;  // views of the same formats are adjacent in their table
    for (const ExportView view : kValues<ExportView>) {
        const std::string own = usualExtensions(view, false);
        if (own != before) {
            help += before.empty() ? "" : " " + before + ", too";
            help += own.empty() ? "" : "; of " + std::string(keyOf(view));
        } else if (!own.empty()) {
            help += " and " + std::string(keyOf(view));
        }
        before = own;
    }
    return help + (before.empty() ? "" : " " + before + ", too");
}

}  // namespace asperity
