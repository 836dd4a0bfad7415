// Gwyddion (GPL 2): a program of its own, so that nothing else is linked to it. Reads columns x
// rows doubles from a file, smooths them and finds the spline's coefficients, writes these back
// into the file and prints the time that both took [ns].
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <libprocess/gwyprocess.h>
#include <memory>

namespace {

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

double smoothAndFit(GwyDataField* field, double sigma) {
    const int columns = gwy_data_field_get_xres(field);
    const int rows = gwy_data_field_get_yres(field);
    const auto begin = std::chrono::steady_clock::now();
    gwy_data_field_filter_gaussian(field, sigma);
    gwy_interpolation_resolve_coeffs_2d(columns, rows, columns, gwy_data_field_get_data(field),
                                        GWY_INTERPOLATION_BSPLINE);
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin)
        .count();
}

int fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        return fail("usage: asperity_gwyddion_fit FILE COLUMNS ROWS SIGMA");
    }
    const int columns = static_cast<int>(std::strtol(argv[2], nullptr, 10));
    const int rows = static_cast<int>(std::strtol(argv[3], nullptr, 10));
    const File file(std::fopen(argv[1], "r+b"), std::fclose);
    if (!file || columns < 1 || rows < 1) {
        return fail("there is no such file or no such size");
    }
    gwy_process_type_init();
    GwyDataField* field = gwy_data_field_new(columns, rows, 1.0, 1.0, FALSE);
    double* heights = gwy_data_field_get_data(field);
    const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    if (std::fread(heights, sizeof(double), count, file.get()) != count) {
        return fail("the file is too short");
    }
    const double time = smoothAndFit(field, std::strtod(argv[4], nullptr));
    std::rewind(file.get());
    if (std::fwrite(heights, sizeof(double), count, file.get()) != count) {
        return fail("the coefficients could not be written");
    }
    std::printf("%.0f\n", time);
    g_object_unref(field);
    return 0;
}
