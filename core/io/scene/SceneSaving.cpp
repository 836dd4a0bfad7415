#include "core/io/scene/SceneSaving.h"

#include "core/TemporaryFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneFiles.h"

namespace asperity {

namespace {

/// Whether a way from one to the other need not pass the root of the file system.
bool haveFolderInCommon(const std::filesystem::path& a, const std::filesystem::path& b) {
    const auto first = [](const std::filesystem::path& path) {
        const std::filesystem::path below = path.relative_path();
        return below.empty() ? std::filesystem::path() : *below.begin();
    };
    return a.root_path() == b.root_path() && first(a) == first(b) && !first(a).empty();
}

}  // namespace

void saveScene(const SceneDescription& scene, const std::filesystem::path& file,
               const std::string& window) {
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    SceneDescription saved = withoutHashes(scene);
    forEachFile(saved, [&folder](std::string& name) {
        const std::filesystem::path read = name;
        if (read.is_absolute() && haveFolderInCommon(read.parent_path(), folder)) {
            name = read.lexically_relative(folder.lexically_normal()).string();
        }
    });
    OutputFile output(file);
    output.stream() << sceneText(saved) << window;
    output.commitToDisk();
}

}  // namespace asperity
