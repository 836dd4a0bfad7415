#include "app/program/RuntimeFolder.h"

#include "core/Error.h"

#include <cstdlib>

namespace asperity {

namespace {

constexpr const char* kVariable = "XDG_RUNTIME_DIR";

}  // namespace

// NOLINTBEGIN(concurrency-mt-unsafe): the header says when

RuntimeFolder::RuntimeFolder() {
    const char* const given = std::getenv(kVariable);
    if (given != nullptr && *given != '\0') {
        return;
    }
    try {
        own_.emplace();
        setenv(kVariable, own_->path().c_str(), 1);
    } catch (const FileError&) {  // Qt can make none there either, and goes on without
    }
}

RuntimeFolder::~RuntimeFolder() {
    if (own_) {
        unsetenv(kVariable);
    }
}

// NOLINTEND(concurrency-mt-unsafe)

}  // namespace asperity
