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
                                                    "derived/cl0_height_f32.exr",
                                                    "igor/spot_1-1000nm.ibw",
                                                    "igor/10x10-one_channel_without_name.ibw",
                                                    "nanonis/STM_nanonis_generic_4_5.sxm",
                                                    "nid/circles.nid",
                                                    "nid/squares_holes.nid",
                                                    "mi/mi-1.mi",
                                                    "wsxm/top-1.top",
                                                    "wsxm/stp-1.stp",
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
                                                    "bcr/bcrf-1.bcrf",
                                                    "x3p/x3p-2_nonsquare_pixels.x3p",
                                                    "x3p/x3ptools_testing.x3p",
                                                    "x3p/x3ptools_csafe-logo_subdir.x3p",
                                                    "jpk/qi_2020_extracted.jpk-qi-data"};
    return kScans;
}

const std::vector<MalformedScan>& malformedScans() {
    static const std::vector<MalformedScan> kScans = {
        {"nanoscope/malformed_lf_line_endings.001", "line 1", "text mode"},
        {"nanoscope/malformed_truncated.di", "image list 3", "truncated"},
        {"text/malformed_nonsense.txt", "byte 0", "no height map"},
        {"text/malformed_single_column.txt", "line 1", "profile"}};
    return kScans;
}

std::vector<std::string> allScans() {
    std::vector<std::string> files = realScans();
    for (const MalformedScan& scan : malformedScans()) {
        files.push_back(scan.file);
    }
    return files;
}

std::string channelName(const std::string& file, const std::string& title) {
    if (file == "derived/cl0_height_u16_noscale.png") {
        return "gray";
    }
    if (file == "derived/cl0_height_f32.exr") {
        return "Height Sensor";
    }
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
