#include "core/surface/foot/SurfaceFoot.h"

namespace asperity {

const char* effortName(FootEffort effort) noexcept {
    switch (effort) {
    case FootEffort::Local:
        return "local";
    case FootEffort::Global:
        return "global";
    case FootEffort::Certified:
        return "certified";
    }
    return "unknown";
}

const char* proofName(FootProof proof) noexcept {
    switch (proof) {
    case FootProof::NotSought:
        return "not_sought";
    case FootProof::Likely:
        return "likely";
    case FootProof::Nearest:
        return "nearest";
    case FootProof::OutOfReach:
        return "out_of_reach";
    case FootProof::ManyFeet:
        return "many_feet";
    case FootProof::NotConverged:
        return "not_converged";
    }
    return "not_sought";
}

}  // namespace asperity
