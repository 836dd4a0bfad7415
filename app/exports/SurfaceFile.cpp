#include "app/exports/SurfaceFile.h"

#include "vtkplugins/io/VtkFormats.h"

namespace asperity {

HeightMapFormats surfaceFormats() {
    static const std::vector<const HeightMapFormat*> all = [] {
        std::vector<const HeightMapFormat*> list(kHeightMapFormats.begin(),
                                                 kHeightMapFormats.end());
        list.insert(list.end(), kVtkFormats.begin(), kVtkFormats.end());
        return list;
    }();
    return HeightMapFormats(all);
}

std::vector<std::string> surfaceExtensions() {
    std::vector<std::string> extensions;
    for (const HeightMapFormat* const format : surfaceFormats()) {
        if (format->write != nullptr) {
            extensions.emplace_back(format->extensions.front());
        }
    }
    return extensions;
}

}  // namespace asperity
