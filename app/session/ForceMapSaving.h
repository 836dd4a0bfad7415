#pragma once

#include "app/maps/HeldMap.h"
#include "app/session/LongWork.h"

#include <QString>

#include <filesystem>
#include <memory>

namespace asperity {

class MainWindow;

/// Writes the force map of the window: the files of `asperity map`, to the byte.
class ForceMapSaving {
public:
    explicit ForceMapSaving(MainWindow& window);

    /// Asks for a file, and whether those beside it may be replaced.
    void ask(const std::shared_ptr<const HeldMap>& map);
    /// Draws the pictures, then writes the other files in the background; says in the window how it
    /// went. @param gwy a name without a type gets it
    void saveTo(const std::shared_ptr<const HeldMap>& map, const std::filesystem::path& gwy);

private:
    void write(const std::shared_ptr<const HeldMap>& map, const std::filesystem::path& gwy);

    MainWindow& window_;
    LongWork<QString> work_;
};

}  // namespace asperity
