#pragma once

#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// Heights to be smoothed and fitted, row-major, single precision; any unit.
struct FitTask {
    int columns = 0;
    int rows = 0;
    std::vector<float> heights;
    double sigma = 0.0;  ///< of the Gaussian [pixel]
};

/// Coefficients of the cubic B-spline through the smoothed heights, laid out as these. Programs
/// differ near the border, where each continues the map in its own way.
struct FitAnswer {
    std::vector<float> coefficients;
    double time = 0.0;  ///< of smoothing and coefficients, without copies into and out of it [ns]
};

/// Another program that can smooth a map and fit the spline, on one thread.
class FitPeer {
public:
    FitPeer() = default;
    FitPeer(const FitPeer&) = delete;
    FitPeer& operator=(const FitPeer&) = delete;
    virtual ~FitPeer() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    /// @throw Error when the program fails
    [[nodiscard]] virtual FitAnswer fit(const FitTask& task) = 0;
};

/// Those that were found when this was built (tools/peers.txt).
[[nodiscard]] std::vector<std::unique_ptr<FitPeer>> fitPeers();

/// One for each program; only those that were found are compiled.
[[nodiscard]] std::unique_ptr<FitPeer> itkFitPeer();
[[nodiscard]] std::unique_ptr<FitPeer> openCvFitPeer();
[[nodiscard]] std::unique_ptr<FitPeer> openCvFusedFitPeer();
[[nodiscard]] std::unique_ptr<FitPeer> gwyddionFitPeer();

}  // namespace asperity
