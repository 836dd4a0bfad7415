#include "tests/core/io/heightmap/RealScans.h"

#include <cctype>

namespace asperity::test {

const std::vector<std::string>& realScans() {
    static const std::vector<std::string> kScans = {"nanoscope/cl_0deg_xcal_v9.70.spm",
                                                    "nanoscope/di-3_v9.01.di",
                                                    "nanoscope/veeco_v5.12.000",
                                                    "gwy/gwyfile_test_no_units.gwy",
                                                    "derived/cl0_from_spm.gwy",
                                                    "derived/frt2_with_mask.gwy",
                                                    "derived/jpk_force_image.gwy",
                                                    "derived/cl0_height.gsf",
                                                    "park/example_ps.tiff",
                                                    "jpk/qi_2020_data-image.jpk-qi-image",
                                                    "jpk/map25x25_data-image.force.jpk",
                                                    "derived/cl0_height_f32_m.tif",
                                                    "derived/cl0_height_u16.tif",
                                                    "derived/cl0_height_u16.png",
                                                    "derived/cl0_height_u16_noscale.png",
                                                    "derived/cl0_height_f32.exr"};
    return kScans;
}

std::string channelName(const std::string& file, const std::string& title) {
    if (file == "derived/cl0_height_u16_noscale.png") {
        return "gray";
    }
    return file == "derived/cl0_height_f32.exr" ? "Height Sensor" : title;
}

std::string testName(const std::string& file) {
    std::string name = file.substr(file.find('/') + 1);
    for (char& c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
            c = '_';
        }
    }
    return name;
}

}  // namespace asperity::test
