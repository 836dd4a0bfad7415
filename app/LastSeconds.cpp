#include "app/LastSeconds.h"

#include "app/Recording.h"

#include <utility>

namespace asperity {

std::future<LastSeconds> writeLastSeconds(std::filesystem::path folder, const LoadedScene& loaded,
                                          BlackBox box) {
    return std::async(
        std::launch::async, [folder = std::move(folder), &loaded, box = std::move(box)] {
            Recording recording(folder, loaded, box.memory());
            for (const TickSample& sample : box.samples()) {
                recording.take(sample);
            }
            recording.finish();
            return LastSeconds{folder, recording.ticks(), box.samples().back().output.fault};
        });
}

}  // namespace asperity
