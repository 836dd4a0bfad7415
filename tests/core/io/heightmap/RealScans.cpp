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
                                                    "text/gwyddion-export-english.txt",
                                                    "text/gwyddion-export-german.txt",
                                                    "text/matrix-3_gwyddion_export.txt",
                                                    "text/matrix-4_h_w_header.txt",
                                                    "text/matrix-5_plain.txt",
                                                    "text/matrix-6_gwyddion_export_small.txt",
                                                    "text/txt_example_nonsquare.txt",
                                                    "text/xyz-1.txt",
                                                    "text/xyz-1-different-order.txt",
                                                    "text/xyz-2_with_nan.txt",
                                                    "sdf/sdf-1.sdf",
                                                    "bcr/bcrf-1.bcrf"};
    return kScans;
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
