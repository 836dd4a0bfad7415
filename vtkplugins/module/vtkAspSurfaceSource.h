#ifndef vtkAspSurfaceSource_h
#define vtkAspSurfaceSource_h

#include "core/surface/BSplineSurface.h"
#include "vtkAsperityModule.h"

#include <vtkPolyDataAlgorithm.h>

/// A rectangular window of a B-spline surface as triangle strips, with the spline's own normals and
/// its height [m] as the point scalars "height". World frame, meters.
class VTKASPERITY_EXPORT vtkAspSurfaceSource : public vtkPolyDataAlgorithm {
public:
    static vtkAspSurfaceSource* New();
    vtkAspSurfaceSource(const vtkAspSurfaceSource&) = delete;
    void operator=(const vtkAspSurfaceSource&) = delete;
    vtkTypeMacro(vtkAspSurfaceSource, vtkPolyDataAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    /// The surface to sample; the caller keeps it alive while the source may update.
    void SetSurface(const asperity::BSplineSurface* surface);

    /// The window: x from, x to, y from, y to [m].
    vtkSetVector4Macro(Window, double);
    vtkGetVector4Macro(Window, double);

    /// Points along x and along y, at least 2 each.
    vtkSetVector2Macro(Resolution, int);
    vtkGetVector2Macro(Resolution, int);

    /// A part of the window to leave open: x from, x to, y from, y to [m]. Grid lines run along its
    /// edges, so that something else can fill it. Empty (the default): no hole.
    vtkSetVector4Macro(Hole, double);
    vtkGetVector4Macro(Hole, double);

protected:
    vtkAspSurfaceSource();
    ~vtkAspSurfaceSource() override = default;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    const asperity::BSplineSurface* Surface = nullptr;
    double Window[4] = {0.0, 0.0, 0.0, 0.0};
    int Resolution[2] = {128, 128};
    double Hole[4] = {0.0, 0.0, 0.0, 0.0};
};

#endif
