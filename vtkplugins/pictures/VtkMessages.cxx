#include "vtkplugins/pictures/VtkMessages.h"

#include <vtkLogger.h>
#include <vtkObject.h>

namespace asperity {

void silenceVtk() {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkObject::GlobalWarningDisplayOff();
}

}  // namespace asperity
