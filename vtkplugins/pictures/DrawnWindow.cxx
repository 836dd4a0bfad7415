#include "vtkplugins/pictures/DrawnWindow.h"

#include "core/Error.h"
#include "vtkplugins/pictures/Display.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr int kMinSide = 32;
constexpr int kMaxSide = 8192;  // twice as many are drawn: the largest frame of OpenGL drivers

/// Wider lines while it lives.
class ScaledLines {
public:
    ScaledLines(vtkRenderWindow* window, double scale) {
        if (scale == 1.0) {
            return;
        }
        vtkRendererCollection* renderers = window->GetRenderers();
        renderers->InitTraversal();
        while (vtkRenderer* renderer = renderers->GetNextItem()) {
            vtkActorCollection* actors = renderer->GetActors();
            actors->InitTraversal();
            while (vtkActor* actor = actors->GetNextActor()) {
                vtkProperty* property = actor->GetProperty();
                before_.emplace_back(property, property->GetLineWidth());
                property->SetLineWidth(static_cast<float>(scale) * property->GetLineWidth());
            }
        }
    }
    ~ScaledLines() {
        // Backwards: actors may share a property, which is then scaled more than once.
        for (auto at = before_.rbegin(); at != before_.rend(); ++at) {
            at->first->SetLineWidth(at->second);
        }
    }
    ScaledLines(const ScaledLines&) = delete;
    ScaledLines& operator=(const ScaledLines&) = delete;

private:
    std::vector<std::pair<vtkProperty*, float>> before_;
};

/// Averages blocks of pixels, of which VTK's lowest row is the first.
class Averaging {
public:
    Averaging(const unsigned char* drawn, int drawnWidth, int oversampling, bool transparent)
        : drawn_(drawn)
        , drawnWidth_(static_cast<std::size_t>(drawnWidth))
        , over_(static_cast<std::size_t>(oversampling))
        , transparent_(transparent) {}

    /// @param row of the picture, from below
    void pixel(std::size_t column, std::size_t row, std::uint8_t* to) const {
        std::array<unsigned, 4> sum{};
        for (std::size_t y = row * over_; y < (row + 1) * over_; ++y) {
            const unsigned char* from = drawn_ + 4 * (y * drawnWidth_ + column * over_);
            for (std::size_t i = 0; i < 4 * over_; ++i) {
                sum[i % 4] += from[i];
            }
        }
        const auto count = static_cast<unsigned>(over_ * over_);
        for (std::size_t c = 0; c < 3; ++c) {
            to[c] = transparent_ ? share(255U * sum[c], sum[3]) : share(sum[c], count);
        }
        to[3] = transparent_ ? share(sum[3], count) : std::uint8_t{255};
    }

private:
    static std::uint8_t share(unsigned sum, unsigned of) {
        return of == 0 ? std::uint8_t{0}
                       : static_cast<std::uint8_t>(std::min(255U, (sum + of / 2) / of));
    }

    const unsigned char* drawn_;
    std::size_t drawnWidth_;
    std::size_t over_;
    bool transparent_;
};

}  // namespace

void requireDrawable(PictureSize size) {
    const auto good = [](int side) { return side >= kMinSide && side <= kMaxSide; };
    if (!good(size.width) || !good(size.height)) {
        throw Error("A picture of " + std::to_string(size.width) + " x " +
                    std::to_string(size.height) + " pixels cannot be drawn: each side must be " +
                    std::to_string(kMinSide) + " to " + std::to_string(kMaxSide) + ".");
    }
}

void prepareOffscreen(vtkRenderWindow* window, PictureSize size, int oversampling) {
    requireDrawable(size);
    if (!haveDisplay()) {
        throw Error("Pictures need an X display and none answers: start the program in a desktop "
                    "session or under xvfb-run.");
    }
    const PictureSize drawn{.width = size.width * oversampling,
                            .height = size.height * oversampling};
    requireDrawingMemory(drawn);
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(1);
    window->SetSize(drawn.width, drawn.height);
}

RasterImage drawnImage(vtkRenderWindow* window, int oversampling, bool transparent,
                       double lineScale) {
    const ScaledLines scaled(window, lineScale);
    window->Render();
    if (window->SupportsOpenGL() == 0) {
        throw Error("Pictures need OpenGL 3.2 and this display does not offer it.");
    }
    const int* size = window->GetSize();
    const int width = size[0];
    const int height = size[1];
    vtkNew<vtkUnsignedCharArray> drawn;
    window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, drawn);
    if (drawn->GetNumberOfValues() !=
        static_cast<vtkIdType>(RasterImage::kChannels) * width * height) {
        throw Error("The picture could not be drawn by OpenGL.");
    }
    RasterImage image{.width = width / oversampling, .height = height / oversampling, .pixels = {}};
    image.pixels.resize(image.rowBytes() * static_cast<std::size_t>(image.height));
    const Averaging average(drawn->GetPointer(0), width, oversampling, transparent);
    std::uint8_t* to = image.pixels.data();
    for (int row = image.height - 1; row >= 0; --row) {
        for (int column = 0; column < image.width; ++column, to += RasterImage::kChannels) {
            average.pixel(static_cast<std::size_t>(column), static_cast<std::size_t>(row), to);
        }
    }
    return image;
}

}  // namespace asperity
