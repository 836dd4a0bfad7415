#ifndef vtkAspTipSource_h
#define vtkAspTipSource_h

#include "vtkAsperityModule.h"

#include <vtkPolyDataAlgorithm.h>

/// An AFM tip for drawing: a sphere, or a paraboloid of its radius, that runs smoothly into a
/// conical shank with a flat end. World frame, meters, analytic normals.
class VTKASPERITY_EXPORT vtkAspTipSource : public vtkPolyDataAlgorithm {
public:
    static vtkAspTipSource* New();
    vtkAspTipSource(const vtkAspTipSource&) = delete;
    void operator=(const vtkAspTipSource&) = delete;
    vtkTypeMacro(vtkAspTipSource, vtkPolyDataAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    /// Center of the sphere [m].
    vtkSetVector3Macro(Center, double);
    vtkGetVector3Macro(Center, double);

    /// Radius of the sphere [m].
    vtkSetMacro(Radius, double);
    vtkGetMacro(Radius, double);

    /// Direction from the apex to the shank; need not be of unit length.
    vtkSetVector3Macro(Axis, double);
    vtkGetVector3Macro(Axis, double);

    /// Distance from the apex to the flat end [m]; a low tip is a cap of the sphere alone.
    vtkSetMacro(Height, double);
    vtkGetMacro(Height, double);

    /// Above 0: the tip is a paraboloid to this distance from its axis, and its shank goes on with
    /// the slope that it has there [m]; 0: a sphere.
    vtkSetMacro(ParaboloidReach, double);
    vtkGetMacro(ParaboloidReach, double);

    /// Between the shank of a sphere and its axis, in (0, pi/2) [rad].
    vtkSetMacro(HalfAngle, double);
    vtkGetMacro(HalfAngle, double);

    /// Rings of facets along the shank, at least 1: colors may change along it.
    vtkSetClampMacro(ShankRings, int, 1, 1024);
    vtkGetMacro(ShankRings, int);

    /// Facets around the axis, at least 3.
    vtkSetClampMacro(Resolution, int, 3, 1024);
    vtkGetMacro(Resolution, int);

protected:
    vtkAspTipSource();
    ~vtkAspTipSource() override = default;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    double Center[3] = {0.0, 0.0, 0.0};
    double Radius = 1.0;
    double Axis[3] = {0.0, 0.0, 1.0};
    double Height = 4.0;
    double HalfAngle;
    double ParaboloidReach = 0.0;
    int ShankRings = 1;
    int Resolution = 64;
};

#endif
