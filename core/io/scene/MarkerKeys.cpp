#include "core/io/scene/MarkerKeys.h"

#include "core/Error.h"
#include "core/io/scene/TomlFile.h"

#include <utility>

namespace asperity {

namespace {

double requiredNumber(TomlSection& section, const char* key) {
    if (!section.has(key)) {
        section.refuse(key, "a place of the marker, in meters");
    }
    return section.number(key, 0.0);
}

Marker readMarker(const toml::table& table, const std::filesystem::path& path) {
    TomlSection section(table, path, "");
    Marker marker;
    marker.name = section.text("name", "");
    marker.x = requiredNumber(section, "x_m");
    marker.y = requiredNumber(section, "y_m");
    section.refuseUnknownKeys();
    return marker;
}

}  // namespace

std::vector<Marker> readMarkers(const toml::table& scene, const std::filesystem::path& path) {
    const toml::node* const node = scene.get(kMarkers);
    if (node == nullptr) {
        return {};
    }
    const toml::array* const list = node->as_array();
    if (list == nullptr || !(list->empty() || list->is_array_of_tables())) {
        throw InputError(path.string(), "line " + std::to_string(node->source().begin.line),
                         "'marker' must be a list of tables, each written [[marker]]");
    }
    std::vector<Marker> markers;
    for (const toml::node& one : *list) {
        markers.push_back(readMarker(*one.as_table(), path));
    }
    return markers;
}

void insertMarkers(const std::vector<Marker>& markers, toml::table& scene) {
    if (markers.empty()) {
        return;
    }
    toml::array list;
    for (const Marker& marker : markers) {
        list.push_back(toml::table{{"name", marker.name}, {"x_m", marker.x}, {"y_m", marker.y}});
    }
    scene.insert(kMarkers, std::move(list));
}

}  // namespace asperity
