#include "vtkplugins/pictures/OffscreenPicture.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "vtkplugins/pictures/Display.h"
#include "vtkplugins/pictures/DrawingMemory.h"
#include "vtkplugins/pictures/PainterItem.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWindowToImageFilter.h>

#include <string>
#include <utility>

namespace asperity {

namespace {

constexpr int kLayers = 4;  // paper, solid things, things that show through, painting
constexpr int kMinSide = 64;
constexpr int kMaxSide = 4096;

void checkSize(PictureSize size) {
    const auto good = [](int side) { return side >= kMinSide && side <= kMaxSide; };
    if (!good(size.width) || !good(size.height)) {
        throw Error("A picture of " + std::to_string(size.width) + " x " +
                    std::to_string(size.height) + " pixels cannot be drawn: each side must be " +
                    std::to_string(kMinSide) + " to " + std::to_string(kMaxSide) + ".");
    }
}

}  // namespace

OffscreenPicture::OffscreenPicture(PictureSize size) : size_(size) {
    checkSize(size);
    if (!haveDisplay()) {
        throw Error("Pictures need an X display and none answers: start the program in a desktop "
                    "session or under xvfb-run.");
    }
    const PictureSize drawn{.width = size.width * kOversampling,
                            .height = size.height * kOversampling};
    requireDrawingMemory(drawn);
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SetSize(drawn.width, drawn.height);
    window_->SetNumberOfLayers(kLayers);

    vtkRenderer* paper = addView({0.0, 0.0, double(size.width), double(size.height)}, 0);
    paper->SetBackground(kLightPalette.paper.fractions().data());
    flat_ = addView({0.0, 0.0, double(size.width), double(size.height)}, kLayers - 1);
    flatActor_ = vtkSmartPointer<vtkContextActor>::New();
    flatActor_->GetScene()->SetRenderer(flat_);
    flat_->AddActor(flatActor_);
}

OffscreenPicture::~OffscreenPicture() = default;

vtkRenderer* OffscreenPicture::addView(const PixelRect& area, int layer) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetLayer(layer);
    renderer->SetViewport(area.left / size_.width, area.bottom / size_.height,
                          area.right() / size_.width, area.top() / size_.height);
    window_->AddRenderer(renderer);
    return renderer;
}

void OffscreenPicture::addItem(vtkAbstractContextItem* item) {
    flatActor_->GetScene()->AddItem(item);
}

void OffscreenPicture::paint(std::function<void(Painter&)> draw) {
    vtkNew<PainterItem> item;
    item->setDraw(std::move(draw), kOversampling);
    addItem(item);
}

PixelPoint OffscreenPicture::project(vtkRenderer* view, const Vector3& point) {
    view->SetWorldPoint(point.x(), point.y(), point.z(), 1.0);
    view->WorldToDisplay();
    const double* display = view->GetDisplayPoint();
    return {display[0] / kOversampling, display[1] / kOversampling};
}

void OffscreenPicture::writePng(const std::filesystem::path& path) {
    window_->Render();
    if (window_->SupportsOpenGL() == 0) {
        throw Error("Pictures need OpenGL 3.2 and this display does not offer it.");
    }
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window_);
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    vtkNew<vtkImageShrink3D> average;
    average->SetInputConnection(grab->GetOutputPort());
    average->SetShrinkFactors(kOversampling, kOversampling, 1);
    average->AveragingOn();
    average->Update();
    if (average->GetOutput()->GetNumberOfPoints() !=
        static_cast<vtkIdType>(size_.width) * size_.height) {
        throw Error("The picture " + path.string() + " could not be drawn by OpenGL.");
    }
    const TemporaryFile file(path);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(average->GetOutputPort());
    writer->SetFileName(file.path().c_str());
    writer->Write();
    if (writer->GetErrorCode() != vtkErrorCode::NoError) {
        throw Error(path.string() + ": writing stopped half-way (disk full?)");
    }
    file.commit();
}

}  // namespace asperity
