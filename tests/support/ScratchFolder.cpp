#include "tests/support/ScratchFolder.h"

#include <atomic>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace asperity::test {

ScratchFolder::ScratchFolder() {
    static std::atomic<int> counter = 0;
    const std::string name =
        "asperity-test-" + std::to_string(getpid()) + "-" + std::to_string(counter++);
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::write(const std::string& name,
                                           const std::string& content) const {
    std::ofstream(file(name), std::ios::binary) << content;
    return file(name);
}

std::string contentOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace asperity::test
