#ifndef vtkAspHeightMapReader_h
#define vtkAspHeightMapReader_h

#include "vtkAsperityParaViewModule.h"

#include <vtkImageAlgorithm.h>

#include <memory>

class vtkStringArray;

/// One height channel of a scan file as an image at the pixel centers, origin at the scan's lower
/// left corner: point scalars "height", NaN where the scan holds no data. All lengths in
/// LengthUnit. It gives any extent, so that each rank reads the rows of its own.
class VTKASPERITYPARAVIEW_EXPORT vtkAspHeightMapReader : public vtkImageAlgorithm {
public:
    static vtkAspHeightMapReader* New();
    vtkAspHeightMapReader(const vtkAspHeightMapReader&) = delete;
    void operator=(const vtkAspHeightMapReader&) = delete;
    vtkTypeMacro(vtkAspHeightMapReader, vtkImageAlgorithm)
    void PrintSelf(ostream& os, vtkIndent indent) override;

    vtkSetFilePathMacro(FileName);
    vtkGetFilePathMacro(FileName);
    /// Returns whether the content, whatever the name, is of a known type.
    int CanReadFile(const char* name);

    /// Name of the channel; empty: the one that a lab user expects.
    vtkSetStringMacro(Channel);
    vtkGetStringMacro(Channel);
    /// Names of the height channels, the default one first; empty before the file is known.
    vtkStringArray* GetChannels();

    /// Unit of lengths [m].
    vtkSetMacro(LengthUnit, double);
    vtkGetMacro(LengthUnit, double);

    /// Width and height of the scan of a file that does not say it [m]; 0: as in the file.
    vtkSetVector2Macro(Size, double);
    vtkGetVector2Macro(Size, double);
    /// Height of a value of 1 in such a file [m]; 0: as in the file.
    vtkSetMacro(HeightPerValue, double);
    vtkGetMacro(HeightPerValue, double);

protected:
    vtkAspHeightMapReader();
    ~vtkAspHeightMapReader() override;
    int RequestInformation(vtkInformation* request, vtkInformationVector** input,
                           vtkInformationVector* output) override;
    int RequestData(vtkInformation* request, vtkInformationVector** input,
                    vtkInformationVector* output) override;

private:
    struct Opened;  // pimpl: ParaView's wrappers read this header

    const Opened& Open();
    int Inform(vtkInformationVector* output);
    int Read(vtkInformationVector* output);

    char* FileName = nullptr;
    char* Channel = nullptr;
    double LengthUnit = 1e-9;
    double Size[2] = {0.0, 0.0};
    double HeightPerValue = 0.0;
    std::unique_ptr<Opened> File;
};

#endif
