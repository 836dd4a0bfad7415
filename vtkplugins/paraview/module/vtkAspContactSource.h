#ifndef vtkAspContactSource_h
#define vtkAspContactSource_h

#include "vtkAsperityParaViewModule.h"

#include <vtkPolyDataAlgorithm.h>

/// A tip that has approached to a setpoint at a position of a scene, by the believed model. Three
/// outputs, world frame, lengths in LengthUnit:
/// 0, the deformed surface around the contact, point scalars "displacement", into the sample;
/// 1, the tip;
/// 2, the force of the sample on the tip as an arrow from the contact, at its points "force" [N],
/// "indentation", "contact_radius", "tip" (its apex).
/// The first rank has all of it.
class VTKASPERITYPARAVIEW_EXPORT vtkAspContactSource : public vtkPolyDataAlgorithm {
public:
    static vtkAspContactSource* New();
    vtkAspContactSource(const vtkAspContactSource&) = delete;
    void operator=(const vtkAspContactSource&) = delete;
    vtkTypeMacro(vtkAspContactSource, vtkPolyDataAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    /// A scene, or a height map, which means a scene with defaults.
    vtkSetFilePathMacro(SceneFile);
    vtkGetFilePathMacro(SceneFile);

    /// x and y from the lower left corner of the scan, in LengthUnit; below 0: its middle.
    vtkSetVector2Macro(Place, double);
    vtkGetVector2Macro(Place, double);

    /// Force along z [N]; 0: the scene's.
    vtkSetMacro(Setpoint, double);
    vtkGetMacro(Setpoint, double);

    /// Unit of lengths [m].
    vtkSetMacro(LengthUnit, double);
    vtkGetMacro(LengthUnit, double);

    /// Half the width of the deformed surface, in LengthUnit; 0: about two tip radii.
    vtkSetMacro(HalfWidth, double);
    vtkGetMacro(HalfWidth, double);

    /// Points of the deformed surface, a side.
    vtkSetClampMacro(Samples, int, 2, 2048);
    vtkGetMacro(Samples, int);

    /// Length of the arrow per force, in LengthUnit per nanonewton; 0: as long as half of
    /// the surface is wide.
    vtkSetMacro(ArrowScale, double);
    vtkGetMacro(ArrowScale, double);

protected:
    vtkAspContactSource();
    ~vtkAspContactSource() override;
    int RequestInformation(vtkInformation* request, vtkInformationVector** input,
                           vtkInformationVector* output) override;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    void Compute(vtkInformationVector* output);

    char* SceneFile = nullptr;
    double Place[2] = {-1.0, -1.0};
    double Setpoint = 0.0;
    double LengthUnit = 1e-9;
    double HalfWidth = 0.0;
    int Samples = 241;
    double ArrowScale = 0.0;
};

#endif
