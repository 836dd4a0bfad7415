#include "app/RunFolder.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <system_error>

namespace asperity {

RunRecorder::RunRecorder(const std::filesystem::path& folder)
    : log_(folder / run_files::kLog), input_(folder / run_files::kInput) {}

void RunRecorder::take(const TickSample& sample) {
    log_.take(sample);
    input_.take(sample);
}

void RunRecorder::close() {
    log_.close();
    input_.close();
}

void makeOutputFolder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        throw Error(folder.string() + ": the folder cannot be made: " + failure.message());
    }
}

void removeEarlierResults(const std::filesystem::path& folder) {
    for (const char* name :
         {run_files::kMemory, run_files::kDeformation, run_files::kDeformationFields,
          run_files::kOverview, run_files::kForces}) {
        std::error_code failure;
        std::filesystem::remove(folder / name, failure);
        if (failure) {
            throw Error((folder / name).string() +
                        ": the earlier run's file cannot be removed: " + failure.message());
        }
    }
}

void writeTextFile(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path);
    file.stream() << text;
    file.commit();
}

}  // namespace asperity
