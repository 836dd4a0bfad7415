#include "ui/view/ForceScale.h"

namespace asperity {

double arrowLength(double magnitude, double usual, double room) {
    return room * magnitude / (magnitude + usual);
}

}  // namespace asperity
