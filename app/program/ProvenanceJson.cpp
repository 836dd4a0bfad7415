#include "app/program/ProvenanceJson.h"

namespace asperity {

nlohmann::ordered_json provenanceJson(const std::vector<Provenance>& entries) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Provenance& entry : entries) {
        list.push_back({{"what", entry.what}, {"value", entry.value}, {"source", entry.source}});
    }
    return list;
}

}  // namespace asperity
