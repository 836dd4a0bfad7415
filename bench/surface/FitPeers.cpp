#include "bench/surface/FitPeer.h"

namespace asperity {

std::vector<std::unique_ptr<FitPeer>> fitPeers() {
    std::vector<std::unique_ptr<FitPeer>> peers;
#ifdef ASPERITY_ITK
    peers.push_back(itkFitPeer());
#endif
#ifdef ASPERITY_OPENCV
    peers.push_back(openCvFitPeer());
    peers.push_back(openCvFusedFitPeer());
#endif
#ifdef ASPERITY_GWYDDION
    peers.push_back(gwyddionFitPeer());
#endif
    return peers;
}

}  // namespace asperity
