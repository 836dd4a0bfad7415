#include "tests/support/Places.h"

namespace asperity::test {

std::filesystem::path checkout() { return ASPERITY_CHECKOUT; }

std::filesystem::path dataFolder() { return checkout() / "data"; }

std::filesystem::path referenceFolder() { return checkout() / "tests" / "reference"; }

std::filesystem::path programOfBuild(const std::string& name) {
    // All programs are built into one folder.
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace asperity::test
