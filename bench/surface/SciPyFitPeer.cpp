// SciPy, in a process of its own (scipy_fit.py).
#include "bench/CommandOutput.h"
#include "bench/surface/FitPeer.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace asperity {

namespace {

/// Debian's own interpreter: the one that its package python3-scipy is for.
constexpr const char* kPython = "/usr/bin/python3";

class SciPy : public FitPeer {
public:
    [[nodiscard]] std::string name() const override { return "SciPy float32"; }

    [[nodiscard]] FitAnswer fit(const FitTask& task) override {
        const TemporaryFile file(std::filesystem::temp_directory_path() / "asperity_scipy.raw");
        const auto bytes = static_cast<std::streamsize>(task.heights.size() * sizeof(float));
        std::ofstream(file.path(), std::ios::binary)
            .write(reinterpret_cast<const char*>(task.heights.data()), bytes);
        std::ostringstream command;
        command << kPython << " '" << ASPERITY_SCIPY_FIT << "' '" << file.path().string() << "' "
                << task.columns << ' ' << task.rows << ' ' << task.sigma << " 2>/dev/null";
        const std::string time = firstLineOf(command.str());
        if (time.empty()) {
            throw Error("SciPy is not installed");
        }
        FitAnswer answer{.coefficients = std::vector<float>(task.heights.size()),
                         .time = std::stod(time)};
        std::ifstream(file.path(), std::ios::binary)
            .read(reinterpret_cast<char*>(answer.coefficients.data()), bytes);
        return answer;
    }
};

}  // namespace

std::unique_ptr<FitPeer> sciPyFitPeer() { return std::make_unique<SciPy>(); }

}  // namespace asperity
