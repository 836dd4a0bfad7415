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
                                                    "igor/spot_1-1000nm.ibw",
                                                    "igor/10x10-one_channel_without_name.ibw",
                                                    "nanonis/STM_nanonis_generic_4_5.sxm",
                                                    "nid/circles.nid",
                                                    "nid/squares_holes.nid",
                                                    "mi/mi-1.mi",
                                                    "wsxm/top-1.top",
                                                    "wsxm/stp-1.stp"};
    return kScans;
}

std::string channelName(const std::string& file, const std::string& title) {
    return file == "igor/10x10-one_channel_without_name.ibw" ? "gwy3093074346" : title;
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
