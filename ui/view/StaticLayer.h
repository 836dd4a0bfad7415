#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkCallbackCommand;
class vtkObject;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;

namespace asperity {

/// Keeps what a renderer draws (color and depth) from one frame to the next: while nothing in it
/// changes, the kept picture is copied into the frame and its actors are not drawn again.
/// To be used by the bottom layer of a window without multisampling; layers above it that preserve
/// the depth buffer are drawn into the picture as into the scene itself.
class StaticLayer {
public:
    /// @param renderer already in the window; both must outlive this object
    StaticLayer(vtkOpenGLRenderWindow* window, vtkRenderer* renderer);
    ~StaticLayer();
    StaticLayer(const StaticLayer&) = delete;
    StaticLayer& operator=(const StaticLayer&) = delete;

    /// Something in the layer, or the camera, is about to change: the next frame draws it again.
    void invalidate() { valid_ = false; }
    /// Off: every frame draws everything, which is faster where every frame differs.
    void setEnabled(bool enabled);

private:
    static void handleEvent(vtkObject* caller, unsigned long event, void* self, void* data);
    void beginFrame();
    void endFrame();
    void fitSize();
    void copyPicture(bool intoFrame);
    void hideActors();
    void restoreActors();

    vtkOpenGLRenderWindow* window_;
    vtkRenderer* renderer_;
    vtkSmartPointer<vtkOpenGLFramebufferObject> picture_;
    vtkNew<vtkCallbackCommand> observer_;
    bool enabled_ = true;
    bool valid_ = false;            ///< the picture is what would be drawn
    std::vector<vtkProp*> hidden_;  ///< during a frame that shows the picture
    int width_ = 0;                 ///< of the picture [pixel]
    int height_ = 0;
};

}  // namespace asperity
