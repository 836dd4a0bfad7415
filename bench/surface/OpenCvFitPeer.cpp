// OpenCV (Apache 2.0). It has no spline fit: the coefficients are a separable convolution too, with
// a kernel that falls by 2 - sqrt 3 a pixel.
#include "bench/surface/FitPeer.h"

#include <chrono>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace asperity {

namespace {

constexpr int kBorder = cv::BORDER_REFLECT_101;

int gaussianWidth(double sigma) {
    constexpr double kReachInSigmas = 5.0;
    return 2 * static_cast<int>(std::ceil(kReachInSigmas * sigma)) + 1;
}

/// Turns samples into coefficients: sqrt 3 (sqrt 3 - 2)^|k|, to below the rounding of a float.
cv::Mat splineKernel() {
    constexpr int kReach = 14;
    cv::Mat kernel(1, 2 * kReach + 1, CV_64F);
    for (int k = -kReach; k <= kReach; ++k) {
        kernel.at<double>(0, k + kReach) =
            std::sqrt(3.0) * std::pow(std::sqrt(3.0) - 2.0, std::abs(k));
    }
    return kernel;
}

/// Gaussian and spline kernel in one.
cv::Mat fusedKernel(double sigma) {
    const cv::Mat gaussian = cv::getGaussianKernel(gaussianWidth(sigma), sigma, CV_64F).t();
    const cv::Mat spline = splineKernel();
    cv::Mat fused = cv::Mat::zeros(1, gaussian.cols + spline.cols - 1, CV_64F);
    for (int i = 0; i < gaussian.cols; ++i) {
        for (int j = 0; j < spline.cols; ++j) {
            fused.at<double>(0, i + j) += gaussian.at<double>(0, i) * spline.at<double>(0, j);
        }
    }
    return fused;
}

/// The heights as OpenCV sees them, without a copy; it only reads them.
cv::Mat imageOf(const FitTask& task) {
    return {
        task.rows, task.columns, CV_32F,
        const_cast<float*>(task.heights.data())};  // NOLINT(cppcoreguidelines-pro-type-const-cast)
}

/// Runs the work on one thread and returns its result.
template <class Work>
FitAnswer timed(const Work& work) {
    cv::setNumThreads(1);
    const auto begin = std::chrono::steady_clock::now();
    const cv::Mat result = work();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
    return {.coefficients = std::vector<float>(result.begin<float>(), result.end<float>()),
            .time = taken.count()};
}

class OpenCv : public FitPeer {
public:
    [[nodiscard]] std::string name() const override { return "OpenCV, Gaussian then spline"; }

    [[nodiscard]] FitAnswer fit(const FitTask& task) override {
        const cv::Mat image = imageOf(task);
        const cv::Mat spline = splineKernel();
        const int width = gaussianWidth(task.sigma);
        return timed([&] {
            cv::Mat result;
            cv::GaussianBlur(image, result, {width, width}, task.sigma, task.sigma, kBorder);
            cv::sepFilter2D(result, result, CV_32F, spline, spline, {-1, -1}, 0.0, kBorder);
            return result;
        });
    }
};

/// The product's own idea, that both steps are one convolution, in OpenCV.
class OpenCvFused : public FitPeer {
public:
    [[nodiscard]] std::string name() const override { return "OpenCV, both kernels in one"; }

    [[nodiscard]] FitAnswer fit(const FitTask& task) override {
        const cv::Mat image = imageOf(task);
        const cv::Mat kernel = fusedKernel(task.sigma);
        return timed([&] {
            cv::Mat result;
            cv::sepFilter2D(image, result, CV_32F, kernel, kernel, {-1, -1}, 0.0, kBorder);
            return result;
        });
    }
};

}  // namespace

std::unique_ptr<FitPeer> openCvFitPeer() { return std::make_unique<OpenCv>(); }

std::unique_ptr<FitPeer> openCvFusedFitPeer() { return std::make_unique<OpenCvFused>(); }

}  // namespace asperity
