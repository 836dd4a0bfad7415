#include "core/fidelity/FidelityTier.h"

namespace asperity {

const char* nameOf(DeformationTier deformation) noexcept {
    switch (deformation) {
    case DeformationTier::FourPoint:
        return "four points";
    case DeformationTier::ContactRadius:
        return "contact radius";
    case DeformationTier::ClosedForm:
        return "closed form";
    case DeformationTier::HalfSpace:
        return "half-space";
    }
    return "unknown";
}

std::string FidelityTier::name() const {
    return std::string(nameOf(law)) + ", " + nameOf(deformation);
}

std::vector<FidelityTier> fidelityTiers() {
    return {
        {ContactLaw::Hertz, DeformationTier::FourPoint},
        {ContactLaw::Hertz, DeformationTier::ContactRadius},
        {ContactLaw::Split, DeformationTier::FourPoint},
        {ContactLaw::Split, DeformationTier::ContactRadius},
        {ContactLaw::Split, DeformationTier::ClosedForm},
    };
}

Scene sceneWithTier(Scene scene, const FidelityTier& tier) {
    scene.description.law = tier.law;
    scene.description.deformation = tier.deformation;
    scene.lawChoice = {tier.law, "as the tier asks"};
    scene.belief.contact =
        ContactModel(tier.law, scene.belief.contact.pair(),
                     contactOptions(scene.description, scene.description.sample.material));
    return scene;
}

}  // namespace asperity
