#include "app/recording/LastSeconds.h"

#include "app/recording/Recording.h"

#include <utility>

namespace asperity {

std::future<LastSeconds> writeLastSeconds(std::filesystem::path folder, const LoadedScene& loaded,
                                          BlackBox box, double delay) {
    return std::async(
        std::launch::async, [folder = std::move(folder), &loaded, box = std::move(box), delay] {
            Recording recording({folder}, loaded, box.memory(), delay);
            for (const TickSample& sample : box.samples()) {
                recording.take(sample);
            }
            recording.finish();
            return LastSeconds{folder, recording.ticks(), box.samples().back().output.fault};
        });
}

}  // namespace asperity
