#include "app/recording/RunPlace.h"

#include "app/recording/Bundle.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"

#include <algorithm>

namespace asperity {

RunPlace::RunPlace(const std::filesystem::path& input) : folder_(input) {
    std::error_code unknown;
    if (std::filesystem::is_regular_file(input, unknown)) {
        unpacked_.emplace();
        folder_ = unpacked_->path();
        unpackBundle(input, folder_);
    } else if (!std::filesystem::is_directory(input, unknown)) {
        throw InputError(input.string(), "", "expected the folder of a run, or a bundle");
    }
}

std::filesystem::path runOf(const std::filesystem::path& file) {
    const std::vector<std::string>& names = runFileNames();
    return std::ranges::find(names, file.filename().string()) == names.end() ? file
                                                                             : file.parent_path();
}

}  // namespace asperity
