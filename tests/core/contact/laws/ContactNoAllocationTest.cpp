#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/contact/laws/ContactModel.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/AllocationCounter.h"

#include <gtest/gtest.h>

#include <memory>

namespace asperity {
namespace {

TEST(AllocationCounter, Counts) {
    const std::size_t before = test::allocationCount();
    const auto memory = std::make_unique<double>(1.0);
    EXPECT_EQ(test::allocationCount(), before + 1) << *memory;
}

TEST(ContactModel, FindsItsEquilibriumWithoutAllocating) {
    for (const char* material : {"SiO2", "PS", "rubber"}) {
        const ContactModel model(ContactLaw::Split, test::paperPair(material));
        const double compliance = 1.0 / 14.0;
        const double start = 3.0 * model.pullOffApproach(compliance);
        ContactState state;
        double displaced = 0.0;
        int jumps = 0;
        const std::size_t before = test::allocationCount();
        for (int i = 0; i <= 2000; ++i) {
            const double phase = 1.0 - std::abs((i / 1000.0) - 1.0);
            state = model.equilibrium(start * (1.0 - (1.5 * phase)), compliance, {state.branch});
            displaced += surfaceDisplacement(model, state, 1e-9);
            jumps += state.jumped ? 1 : 0;
        }
        const std::size_t after = test::allocationCount();
        EXPECT_EQ(after, before);
        EXPECT_EQ(jumps, 2);
        EXPECT_TRUE(std::isfinite(displaced));
    }
}

}  // namespace
}  // namespace asperity
