#include "ui/view/StaticLayer.h"

#include <vtkCallbackCommand.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPropCollection.h>
#include <vtkRenderer.h>

#include <GL/gl.h>

namespace asperity {

namespace {

constexpr int kDepthBits = 32;  // as the frames of VTK have: other depths cannot be copied

void bindForReading(vtkOpenGLFramebufferObject* buffer) {
    buffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
    buffer->ActivateReadBuffer(0);
}

void bindForDrawing(vtkOpenGLFramebufferObject* buffer) {
    buffer->Bind(vtkOpenGLFramebufferObject::GetDrawMode());
    buffer->ActivateDrawBuffer(0);
}

}  // namespace

StaticLayer::StaticLayer(vtkOpenGLRenderWindow* window, vtkRenderer* renderer)
    : window_(window)
    , renderer_(renderer)
    , picture_(vtkSmartPointer<vtkOpenGLFramebufferObject>::New()) {
    observer_->SetCallback(&StaticLayer::handleEvent);
    observer_->SetClientData(this);
    renderer_->AddObserver(vtkCommand::StartEvent, observer_);
    renderer_->AddObserver(vtkCommand::EndEvent, observer_);
}

StaticLayer::~StaticLayer() { renderer_->RemoveObserver(observer_); }

void StaticLayer::setEnabled(bool enabled) {
    valid_ = valid_ && enabled == enabled_;
    enabled_ = enabled;
}

void StaticLayer::handleEvent(vtkObject* /*caller*/, unsigned long event, void* self,
                              void* /*data*/) {
    auto* layer = static_cast<StaticLayer*>(self);
    if (event == vtkCommand::StartEvent) {
        layer->beginFrame();
    } else {
        layer->endFrame();
    }
}

void StaticLayer::beginFrame() {
    const int* size = window_->GetSize();
    // The buffer is gone when the context was lost.
    valid_ = enabled_ && valid_ && size[0] == width_ && size[1] == height_ &&
             picture_->GetFBOIndex() != 0;
    if (valid_) {
        hideActors();
    }
}

void StaticLayer::endFrame() {
    restoreActors();
    if (!enabled_) {
        return;
    }
    vtkOpenGLState* state = window_->GetState();
    state->PushFramebufferBindings();
    fitSize();
    copyPicture(valid_);
    state->PopFramebufferBindings();
    valid_ = true;
}

void StaticLayer::fitSize() {
    const int* size = window_->GetSize();
    if (size[0] == width_ && size[1] == height_ && picture_->GetFBOIndex() != 0) {
        return;
    }
    width_ = size[0];
    height_ = size[1];
    picture_->SetContext(window_);
    picture_->PopulateFramebuffer(width_, height_, true, 1, VTK_UNSIGNED_CHAR, true, kDepthBits, 0,
                                  false);
}

void StaticLayer::copyPicture(bool intoFrame) {
    vtkOpenGLFramebufferObject* frame = window_->GetRenderFramebuffer();
    bindForReading(intoFrame ? picture_.Get() : frame);
    bindForDrawing(intoFrame ? frame : picture_.Get());
    window_->GetState()->vtkglDisable(GL_SCISSOR_TEST);
    window_->GetState()->vtkglBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_,
                                              GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                                              GL_NEAREST);
}

void StaticLayer::hideActors() {
    vtkPropCollection* props = renderer_->GetViewProps();
    props->InitTraversal();
    while (vtkProp* prop = props->GetNextProp()) {
        if (prop->GetVisibility() != 0) {
            prop->VisibilityOff();
            hidden_.push_back(prop);
        }
    }
}

void StaticLayer::restoreActors() {
    for (vtkProp* prop : hidden_) {
        prop->VisibilityOn();
    }
    hidden_.clear();
}

}  // namespace asperity
