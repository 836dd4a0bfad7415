#include "app/window/UnpackedRun.h"

#include "app/recording/Bundle.h"
#include "core/Error.h"

#include <QStandardPaths>

#include <system_error>

namespace asperity {

std::filesystem::path unpackedRun(const std::filesystem::path& input, Progress* progress) {
    std::error_code unknown;
    if (std::filesystem::is_directory(input, unknown)) {
        return input;
    }
    if (!std::filesystem::is_regular_file(input, unknown)) {
        throw InputError(input.string(), "", "expected the folder of a run, or a bundle");
    }
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return keptBundle(input, std::filesystem::path(folder.toStdString()) / "bundles", progress);
}

}  // namespace asperity
