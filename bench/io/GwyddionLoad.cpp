// Gwyddion (GPL 2): a program of its own, so that nothing else is linked to it. Loads a .gwy file
// as Gwyddion's own module does and looks at every pixel of its first image.
#include "bench/io/LoadAnswer.h"

#include <chrono>
#include <cstdio>
#include <libgwyddion/gwyddion.h>
#include <libprocess/gwyprocess.h>

namespace {

constexpr gsize kMarkSize = 4;  // "GWYP"

int fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        return fail("usage: asperity_gwyddion_load FILE");
    }
    gwy_process_type_init();
    const auto begin = std::chrono::steady_clock::now();
    guchar* bytes = nullptr;
    gsize size = 0;
    if (gwy_file_get_contents(argv[1], &bytes, &size, nullptr) == FALSE || size < kMarkSize) {
        return fail("the file cannot be read");
    }
    gsize position = 0;
    GObject* container =
        gwy_serializable_deserialize(bytes + kMarkSize, size - kMarkSize, &position);
    gwy_file_abandon_contents(bytes, size, nullptr);
    if (container == nullptr || !GWY_IS_CONTAINER(container)) {
        return fail("the file holds no container");
    }
    auto* field = GWY_DATA_FIELD(
        gwy_container_get_object(GWY_CONTAINER(container), g_quark_from_string("/0/data")));
    const auto pixels = static_cast<std::size_t>(gwy_data_field_get_xres(field)) *
                        static_cast<std::size_t>(gwy_data_field_get_yres(field));
    asperity::printLoad(begin, asperity::sumOf(gwy_data_field_get_data_const(field), pixels));
    g_object_unref(container);
    return 0;
}
