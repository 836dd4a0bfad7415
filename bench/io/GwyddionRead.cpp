// Gwyddion (GPL 2): a program of its own, so that nothing else is linked to it. Reads a file of any
// type as Gwyddion does, with its own modules, and looks at every pixel of all its images. The
// modules are loaded before the clock starts.
#include "bench/io/LoadAnswer.h"

#include <chrono>
#include <cstdio>
#include <libgwyddion/gwyddion.h>
#include <libgwymodule/gwymodule-file.h>
#include <libprocess/gwyprocess.h>

// Of libgwyapp, whose header needs GTK: types, resources and modules for a program without windows.
extern "C" void gwy_app_init_nongui(const gchar* option, ...);

namespace {

void addImage(gpointer /*key*/, gpointer value, gpointer sum) {
    GObject* const object = G_VALUE_HOLDS_OBJECT(value)
                                ? G_OBJECT(g_value_get_object(static_cast<const GValue*>(value)))
                                : nullptr;
    if (GWY_IS_DATA_FIELD(object)) {
        auto* const field = GWY_DATA_FIELD(object);
        const auto pixels = static_cast<std::size_t>(gwy_data_field_get_xres(field)) *
                            static_cast<std::size_t>(gwy_data_field_get_yres(field));
        *static_cast<double*>(sum) += asperity::sumOf(gwy_data_field_get_data_const(field), pixels);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: asperity_gwyddion_read FILE\n");
        return 1;
    }
    gwy_app_init_nongui(nullptr);
    const auto begin = std::chrono::steady_clock::now();
    GError* error = nullptr;
    GwyContainer* const container = gwy_file_load(argv[1], GWY_RUN_NONINTERACTIVE, &error);
    if (container == nullptr) {
        std::fprintf(stderr, "%s: %s\n", argv[1], error != nullptr ? error->message : "not read");
        return 1;
    }
    double sum = 0.0;
    gwy_container_foreach(container, nullptr, addImage, &sum);
    asperity::printLoad(begin, sum);
    g_object_unref(container);
    return 0;
}
