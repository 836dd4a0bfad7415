#include "bench/surface/Peers.h"

namespace asperity {

namespace {

struct Peer {
    const char* name;
    std::unique_ptr<SearchMethod> (*make)(const BSplineSurface& surface);  ///< null: not found
};

constexpr Peer kPeers[] = {
#ifdef ASPERITY_OPENCASCADE
    {"OpenCASCADE", openCascadeMethod},
    {"OpenCASCADE", openCascadeWindowMethod},
#else
    {"OpenCASCADE", nullptr},
#endif
#ifdef ASPERITY_SISL
    {"SISL", sislMethod},
#else
    {"SISL", nullptr},
#endif
#ifdef ASPERITY_EMBREE
    {"Embree", embreeMethod},
#else
    {"Embree", nullptr},
#endif
#ifdef ASPERITY_CGAL
    {"CGAL", cgalMethod},
#else
    {"CGAL", nullptr},
#endif
    {"VTK", vtkMethod},
};

}  // namespace

std::vector<std::unique_ptr<SearchMethod>> peerMethods(const BSplineSurface& surface) {
    std::vector<std::unique_ptr<SearchMethod>> methods;
    for (const Peer& peer : kPeers) {
        if (peer.make != nullptr) {
            methods.push_back(peer.make(surface));
        }
    }
    return methods;
}

std::vector<std::string> missingPeers() {
    std::vector<std::string> missing;
    for (const Peer& peer : kPeers) {
        if (peer.make == nullptr) {
            missing.emplace_back(peer.name);
        }
    }
    return missing;
}

}  // namespace asperity
