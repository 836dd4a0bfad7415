#include "tests/core/io/heightmap/RealScans.h"

#include <cctype>

namespace asperity::test {

const std::vector<std::string>& realScans() {
    static const std::vector<std::string> kScans = {
        "nanoscope/cl_0deg_xcal_v9.70.spm",   "nanoscope/di-3_v9.01.di",
        "nanoscope/veeco_v5.12.000",          "gwy/gwyfile_test_no_units.gwy",
        "derived/cl0_from_spm.gwy",           "derived/frt2_with_mask.gwy",
        "derived/jpk_force_image.gwy",        "derived/cl0_height.gsf",
        "x3p/x3p-2_nonsquare_pixels.x3p",     "x3p/x3ptools_testing.x3p",
        "x3p/x3ptools_csafe-logo_subdir.x3p", "jpk/qi_2020_extracted.jpk-qi-data"};
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
