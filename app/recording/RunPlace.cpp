#include "app/recording/RunPlace.h"

#include "app/recording/Bundle.h"
#include "core/Error.h"

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

}  // namespace asperity
