#include "core/io/scene/MaterialMapKeys.h"

#include "core/PathText.h"
#include "core/io/scene/SceneKeys.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kMask = "material_mask";

/// One that a single quantity has.
struct MapKey {
    const char* key;
    const char* number;  ///< key of the same quantity where it is the same everywhere
    std::optional<MapSource> MaterialSources::*source;
};
constexpr std::array<MapKey, 3> kMaps{{
    {"youngs_modulus_map", "youngs_modulus_pa", &MaterialSources::youngsModulus},
    {"work_of_adhesion_map", "work_of_adhesion_j_m2", &MaterialSources::workOfAdhesion},
    {"friction_map", "friction_coefficient", &MaterialSources::friction},
}};

MapSource readSource(TomlSection& section) {
    MapSource source{.file = section.path("file").string(),
                     .channel = section.text("channel", ""),
                     .sha256 = section.text("sha256", "")};
    if (source.file.empty()) {
        section.refuse("file", "the path of a file with the map");
    }
    return source;
}

/// A number of a material that must be there.
double required(TomlSection& numbers, const char* key) {
    if (!numbers.has(key)) {
        numbers.refuse(key, "a number");
    }
    return readNumber(numbers, sceneField(SceneGroup::Material, key), 0.0);
}

/// A material file, or its three numbers.
MaskedMaterial readMasked(TomlSection& mask, const char* key, const MaterialReader& read) {
    if (mask.isText(key)) {
        return read(mask.path(key));
    }
    std::optional<TomlSection> numbers = mask.table(key);
    if (!numbers) {
        mask.refuse(key, "a material file, or a table with the three numbers of a material");
    }
    const MaskedMaterial material{.youngsModulus = required(*numbers, "youngs_modulus_pa"),
                                  .workOfAdhesion = required(*numbers, "work_of_adhesion_j_m2"),
                                  .frictionCoefficient =
                                      required(*numbers, "friction_coefficient")};
    numbers->refuseUnknownKeys();
    return material;
}

toml::table sourceTable(const MapSource& source) {
    toml::table table{{"file", pathText(source.file)}};
    if (!source.channel.empty()) {
        table.insert("channel", source.channel);
    }
    if (!source.sha256.empty()) {
        table.insert("sha256", source.sha256);
    }
    table.is_inline(true);
    return table;
}

toml::table maskedTable(const MaskedMaterial& material) {
    toml::table table{{"youngs_modulus_pa", material.youngsModulus},
                      {"work_of_adhesion_j_m2", material.workOfAdhesion},
                      {"friction_coefficient", material.frictionCoefficient}};
    table.is_inline(true);
    return table;
}

}  // namespace

MaterialSources readMaterialSources(TomlSection& section, const MaterialReader& read) {
    MaterialSources sources;
    for (const auto& [key, number, member] : kMaps) {
        if (std::optional<TomlSection> table = section.table(key)) {
            sources.*member = readSource(*table);
            table->refuseUnknownKeys();
        }
    }
    if (std::optional<TomlSection> table = section.table(kMask)) {
        if (sources.any()) {
            section.refuse(kMask, "a mask, or maps of single quantities, not both");
        }
        const MapSource source = readSource(*table);
        sources.mask = MaterialMask{.source = source,
                                    .zero = readMasked(*table, "zero", read),
                                    .one = readMasked(*table, "one", read)};
        table->refuseUnknownKeys();
    }
    return sources;
}

MaterialSources trueSources(const TomlSection& section, MaterialSources own,
                            const MaterialSources& believed) {
    if (section.has("material") || own.mask) {
        return own;
    }
    const auto numbers =
        std::ranges::count_if(kMaps, [&](const MapKey& map) { return section.has(map.number); });
    if (numbers == 0 && !own.any()) {
        return believed;
    }
    if (believed.mask && numbers < std::ssize(kMaps)) {
        section.refuse(kMask, "a mask of its own, or all of youngs_modulus_pa, "
                              "work_of_adhesion_j_m2 and friction_coefficient, since [sample] has "
                              "a mask: a part of it cannot be told");
    }
    for (const auto& [key, number, member] : kMaps) {
        if (!section.has(number) && !section.has(key)) {
            own.*member = believed.*member;
        }
    }
    return own;
}

void insertMaterialSources(const MaterialSources& sources, toml::table& table) {
    for (const auto& [key, number, member] : kMaps) {
        if (sources.*member) {
            table.insert(key, sourceTable(*(sources.*member)));
        }
    }
    if (sources.mask) {
        toml::table mask = sourceTable(sources.mask->source);
        mask.insert("zero", maskedTable(sources.mask->zero));
        mask.insert("one", maskedTable(sources.mask->one));
        table.insert(kMask, std::move(mask));
    }
}

}  // namespace asperity
