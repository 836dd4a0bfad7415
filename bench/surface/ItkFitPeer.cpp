// ITK (Apache 2.0): recursive Gaussian, then B-spline decomposition.
#include "bench/surface/FitPeer.h"

#include <algorithm>
#include <chrono>
#include <itkBSplineDecompositionImageFilter.h>
#include <itkImage.h>
#include <itkMultiThreaderBase.h>
#include <itkSmoothingRecursiveGaussianImageFilter.h>

namespace asperity {

namespace {

using Image = itk::Image<float, 2>;

Image::Pointer imageOf(const FitTask& task) {
    const Image::Pointer image = Image::New();
    image->SetRegions(Image::SizeType{static_cast<itk::SizeValueType>(task.columns),
                                      static_cast<itk::SizeValueType>(task.rows)});
    image->Allocate();
    std::copy(task.heights.begin(), task.heights.end(), image->GetBufferPointer());
    return image;
}

class Itk : public FitPeer {
public:
    [[nodiscard]] std::string name() const override { return "ITK"; }

    [[nodiscard]] FitAnswer fit(const FitTask& task) override {
        itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(1);
        const auto smoothing = itk::SmoothingRecursiveGaussianImageFilter<Image, Image>::New();
        smoothing->SetInput(imageOf(task));
        smoothing->SetSigma(task.sigma);
        const auto spline = itk::BSplineDecompositionImageFilter<Image, Image>::New();
        spline->SetInput(smoothing->GetOutput());
        spline->SetSplineOrder(3);
        const auto begin = std::chrono::steady_clock::now();
        spline->Update();
        const std::chrono::duration<double, std::nano> taken =
            std::chrono::steady_clock::now() - begin;
        const float* first = spline->GetOutput()->GetBufferPointer();
        return {.coefficients = std::vector<float>(first, first + task.heights.size()),
                .time = taken.count()};
    }
};

}  // namespace

std::unique_ptr<FitPeer> itkFitPeer() { return std::make_unique<Itk>(); }

}  // namespace asperity
