// Gwyddion, in a process of its own (GwyddionFit.cpp).
#include "bench/CommandOutput.h"
#include "bench/surface/FitPeer.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace asperity {

namespace {

void writeDoubles(const std::filesystem::path& path, const std::vector<float>& values) {
    const std::vector<double> doubles(values.begin(), values.end());
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(doubles.data()),
               static_cast<std::streamsize>(doubles.size() * sizeof(double)));
    if (!file.flush()) {
        throw Error("the heights for Gwyddion could not be written to " + path.string());
    }
}

std::vector<float> readDoubles(const std::filesystem::path& path, std::size_t count) {
    std::vector<double> doubles(count);
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(doubles.data()),
              static_cast<std::streamsize>(count * sizeof(double)));
    if (!file) {
        throw Error("Gwyddion's coefficients could not be read from " + path.string());
    }
    return {doubles.begin(), doubles.end()};
}

class Gwyddion : public FitPeer {
public:
    [[nodiscard]] std::string name() const override { return "Gwyddion"; }

    [[nodiscard]] FitAnswer fit(const FitTask& task) override {
        const TemporaryFile file(std::filesystem::temp_directory_path() / "asperity_fit.raw");
        writeDoubles(file.path(), task.heights);
        std::ostringstream command;
        command << "OMP_NUM_THREADS=1 '" << ASPERITY_GWYDDION_FIT << "' '" << file.path().string()
                << "' " << task.columns << ' ' << task.rows << ' ' << task.sigma;
        const std::string time = firstLineOf(command.str());
        if (time.empty()) {
            throw Error("Gwyddion's process gave no answer: " + command.str());
        }
        return {.coefficients = readDoubles(file.path(), task.heights.size()),
                .time = std::stod(time)};
    }
};

}  // namespace

std::unique_ptr<FitPeer> gwyddionFitPeer() { return std::make_unique<Gwyddion>(); }

}  // namespace asperity
