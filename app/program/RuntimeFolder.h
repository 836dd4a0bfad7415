#pragma once

#include "core/PrivateFolder.h"

#include <optional>

namespace asperity {

/// The folder of a desktop session that Qt asks for, XDG_RUNTIME_DIR, for as long as this lives:
/// where there is none, Qt would make one in TMPDIR and leave it there. It is made before the
/// application and outlives it, on the main thread while no other one reads the environment.
class RuntimeFolder {
public:
    RuntimeFolder();
    RuntimeFolder(const RuntimeFolder&) = delete;
    RuntimeFolder& operator=(const RuntimeFolder&) = delete;
    ~RuntimeFolder();

private:
    std::optional<PrivateFolder> own_;
};

}  // namespace asperity
