#ifndef vtkAspPatchSource_h
#define vtkAspPatchSource_h

#include "core/surface/deformation/SurfaceDeformation.h"
#include "vtkAsperityModule.h"

#include <vtkPolyDataAlgorithm.h>

/// The deformed surface around the contact as triangle strips with the patch's own normals. Point
/// scalars "displacement": how far the surface was pushed in along its normal at rest, negative
/// where it was pulled out [m]. World frame, meters.
class VTKASPERITY_EXPORT vtkAspPatchSource : public vtkPolyDataAlgorithm {
public:
    static vtkAspPatchSource* New();
    vtkAspPatchSource(const vtkAspPatchSource&) = delete;
    void operator=(const vtkAspPatchSource&) = delete;
    vtkTypeMacro(vtkAspPatchSource, vtkPolyDataAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    void SetPatch(asperity::SurfacePatch patch);

protected:
    vtkAspPatchSource();
    ~vtkAspPatchSource() override = default;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    asperity::SurfacePatch Patch;
};

#endif
