#include "core/words/HalfSpaceWords.h"

#include "core/SiFormat.h"

namespace asperity {

std::string sentenceOf(const HalfSpaceJudgment& judgment) {
    if (judgment.verdict != HalfSpaceVerdict::Valid) {
        return std::string("half-space not valid (") + nameOf(judgment.verdict) +
               "): closed form shown";
    }
    return "half-space: normal force " + formatSi(judgment.force, "N") + ", the contact law " +
           formatSi(judgment.lawForce, "N");
}

}  // namespace asperity
