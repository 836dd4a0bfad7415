#include "vtkplugins/pictures/OffscreenPicture.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

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
}  // namespace

OffscreenPicture::OffscreenPicture(PictureSize size, const PictureLook& look)
    : size_(size), look_(look) {
    prepareOffscreen(window_, size, kOversampling);
    window_->SetNumberOfLayers(kLayers);

    vtkRenderer* paper = addView(area(), 0);
    if (look.transparent) {
        paper->SetBackground(0.0, 0.0, 0.0);
        paper->SetBackgroundAlpha(0.0);
    } else {
        paper->SetBackground(kLightPalette.paper.fractions().data());
        paper->SetBackgroundAlpha(1.0);
    }
    flat_ = addView(area(), kLayers - 1);
    flatActor_ = vtkSmartPointer<vtkContextActor>::New();
    flatActor_->GetScene()->SetRenderer(flat_);
    flat_->AddActor(flatActor_);
}

OffscreenPicture::~OffscreenPicture() = default;

PixelRect OffscreenPicture::area() const {
    return {0.0, 0.0, size_.width / look_.pixelRatio, size_.height / look_.pixelRatio};
}

vtkRenderer* OffscreenPicture::addView(const PixelRect& area, int layer) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetLayer(layer);
    const PixelRect all = this->area();
    renderer->SetViewport(area.left / all.width, area.bottom / all.height, area.right() / all.width,
                          area.top() / all.height);
    window_->AddRenderer(renderer);
    return renderer;
}

void OffscreenPicture::addItem(vtkAbstractContextItem* item) {
    flatActor_->GetScene()->AddItem(item);
}

void OffscreenPicture::paint(std::function<void(Painter&)> draw) {
    vtkNew<PainterItem> item;
    item->setDraw(std::move(draw), kOversampling * look_.pixelRatio);
    addItem(item);
}

PixelPoint OffscreenPicture::project(vtkRenderer* view, const Vector3& point) const {
    view->SetWorldPoint(point.x(), point.y(), point.z(), 1.0);
    view->WorldToDisplay();
    const double* display = view->GetDisplayPoint();
    const double drawn = kOversampling * look_.pixelRatio;
    return {display[0] / drawn, display[1] / drawn};
}

RasterImage OffscreenPicture::image() {
    return drawnImage(window_, kOversampling, look_.transparent, look_.pixelRatio);
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
