#ifndef vtkAspForceMap_h
#define vtkAspForceMap_h

#include "vtkAsperityParaViewModule.h"

#include <vtkImageAlgorithm.h>

/// Map that a force volume of the input, a height map, would show, as `asperity map` computes it
/// (docs/maps.md): an array for each quantity. The input's lower left pixel begins at the corner of
/// the scan. Lengths are in LengthUnit, as in the input; all else is in SI units.
///
/// The surface is fitted to the whole scan. So each rank asks for all of the input, fits it, and
/// computes the rows of its own piece: the values do not depend on the number of ranks.
class VTKASPERITYPARAVIEW_EXPORT vtkAspForceMap : public vtkImageAlgorithm {
public:
    static vtkAspForceMap* New();
    vtkAspForceMap(const vtkAspForceMap&) = delete;
    void operator=(const vtkAspForceMap&) = delete;
    vtkTypeMacro(vtkAspForceMap, vtkImageAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    /// Tip, lever, material and model; empty: those of a height map alone.
    vtkSetFilePathMacro(SceneFile);
    vtkGetFilePathMacro(SceneFile);

    /// 0: approach and retract at each pixel; 1: a raster at constant force.
    vtkSetClampMacro(Mode, int, 0, 1);
    vtkGetMacro(Mode, int);

    /// Force along z that ends the approach [N]; 0: the scene's.
    vtkSetMacro(Setpoint, double);
    vtkGetMacro(Setpoint, double);

    /// Keys of the quantities, separated by commas; empty: all of the mode.
    vtkSetStringMacro(Quantities);
    vtkGetStringMacro(Quantities);

    /// Columns and rows of the map; 0: those of the input.
    vtkSetVector2Macro(Grid, int);
    vtkGetVector2Macro(Grid, int);

    /// True to map the simulated true instrument, instead of the model.
    vtkSetMacro(Truth, bool);
    vtkGetMacro(Truth, bool);

    /// Unit of lengths of input and output [m].
    vtkSetMacro(LengthUnit, double);
    vtkGetMacro(LengthUnit, double);

    /// Threads of each rank; 0: all cores where there is one rank, else one thread.
    vtkSetClampMacro(Threads, int, 0, 1024);
    vtkGetMacro(Threads, int);

protected:
    vtkAspForceMap();
    ~vtkAspForceMap() override;
    int RequestInformation(vtkInformation* request, vtkInformationVector** input,
                           vtkInformationVector* output) override;
    int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** input,
                            vtkInformationVector* output) override;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    /// Columns and rows of the map of an input of this extent.
    void GridOf(const int extent[6], int grid[2]) const;
    int Compute(vtkInformationVector** input, vtkInformationVector* output);

    char* SceneFile = nullptr;
    char* Quantities = nullptr;
    int Mode = 0;
    double Setpoint = 0.0;
    int Grid[2] = {0, 0};
    bool Truth = false;
    double LengthUnit = 1e-9;
    int Threads = 0;
};

#endif
