#pragma once

#include "app/program/LoadedScene.h"
#include "core/haptics/blackbox/BlackBox.h"

#include <filesystem>
#include <future>

namespace asperity {

/// A black box written as a recording.
struct LastSeconds {
    std::filesystem::path folder;
    long ticks = 0;
    Fault fault = Fault::None;  ///< of the last tick
};

/// Writes it on a thread of its own.
/// @param box holds ticks
/// @param loaded outlives the writing
/// @param delay  of the device [s]
/// @return throws Error where the folder cannot be written; its destructor waits
[[nodiscard]] std::future<LastSeconds> writeLastSeconds(std::filesystem::path folder,
                                                        const LoadedScene& loaded, BlackBox box,
                                                        double delay);

}  // namespace asperity
