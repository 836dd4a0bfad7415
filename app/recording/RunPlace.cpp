#include "app/recording/RunPlace.h"

#include "app/recording/Bundle.h"
#include "app/runs/RunFolder.h"
#include "core/PrintableText.h"

#include <algorithm>
#include <string>

namespace asperity {

namespace {

std::string replacedAll(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); at != std::string::npos;
         at = text.find(part, at + by.size())) {
        text.replace(at, part.size(), by);
    }
    return text;
}

}  // namespace

RunPlace::RunPlace(const std::filesystem::path& input) : input_(input), folder_(input) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(input, unknown)) {
        unpacked_.emplace();
        folder_ = unpacked_->path();
        unpackBundle(input, folder_);
    } else if (!std::filesystem::is_directory(input, unknown)) {
        throw InputError(input.string(), "", "expected the folder of a run, or a bundle");
    }
}

void throwAsPartOf(const std::filesystem::path& bundle, const std::filesystem::path& folder,
                   const FileError& refusal) {
    const std::string text = refusal.what();
    const std::string place = printable(folder.string());
    if (text.find(place) == std::string::npos) {
        throw;
    }
    const std::string name = printable(bundle.string());
    const std::string named = replacedAll(replacedAll(text, place + "/", name + ", "), place, name);
    constexpr std::string_view kAfterFile = ": ";
    const std::size_t end = named.find(kAfterFile);
    throw InputError(named.substr(0, end), "", named.substr(end + kAfterFile.size()));
}

std::filesystem::path runOf(const std::filesystem::path& file) {
    const std::vector<std::string>& names = runFileNames();
    return std::ranges::find(names, file.filename().string()) == names.end() ? file
                                                                             : file.parent_path();
}

}  // namespace asperity
