#include "core/io/scene/UncertaintyKeys.h"

namespace asperity {

void readUncertainty(TomlSection section, Uncertainty& uncertainty) {
    uncertainty.enabled = section.flag("enabled", uncertainty.enabled);
    uncertainty.thermalStiffness = section.flag("thermal_stiffness", uncertainty.thermalStiffness);
    for (const UncertaintyRow& row : kEnumTable<UncertaintyInput>) {
        if (row.deviation != nullptr) {
            double& deviation = uncertainty.*row.deviation;
            deviation = section.number(row.key, deviation);
        }
    }
    section.refuseUnknownKeys();
}

toml::table uncertaintyTable(const Uncertainty& uncertainty) {
    toml::table table{{"enabled", uncertainty.enabled},
                      {"thermal_stiffness", uncertainty.thermalStiffness}};
    for (const UncertaintyRow& row : kEnumTable<UncertaintyInput>) {
        if (row.deviation != nullptr) {
            table.insert(row.key, uncertainty.*row.deviation);
        }
    }
    return table;
}

}  // namespace asperity
