#ifndef vtkAspForceGlyphSource_h
#define vtkAspForceGlyphSource_h

#include "vtkAsperityModule.h"

#include <vtkPolyDataAlgorithm.h>

/// A force as an arrow that starts at the contact point and points the way the force acts on the
/// tip; its length is proportional to the force. A force of zero gives empty output. World frame.
class VTKASPERITY_EXPORT vtkAspForceGlyphSource : public vtkPolyDataAlgorithm {
public:
    static vtkAspForceGlyphSource* New();
    vtkAspForceGlyphSource(const vtkAspForceGlyphSource&) = delete;
    void operator=(const vtkAspForceGlyphSource&) = delete;
    vtkTypeMacro(vtkAspForceGlyphSource, vtkPolyDataAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    /// Start of the arrow [m].
    vtkSetVector3Macro(ContactPoint, double);
    vtkGetVector3Macro(ContactPoint, double);

    /// Force of the sample on the tip [N].
    vtkSetVector3Macro(Force, double);
    vtkGetVector3Macro(Force, double);

    /// Length of the arrow per force [m/N].
    vtkSetMacro(MetersPerNewton, double);
    vtkGetMacro(MetersPerNewton, double);

    /// Facets around the arrow, at least 3.
    vtkSetClampMacro(Resolution, int, 3, 1024);
    vtkGetMacro(Resolution, int);

protected:
    vtkAspForceGlyphSource();
    ~vtkAspForceGlyphSource() override = default;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    double ContactPoint[3] = {0.0, 0.0, 0.0};
    double Force[3] = {0.0, 0.0, 0.0};
    double MetersPerNewton = 1.0;
    int Resolution = 32;
};

#endif
