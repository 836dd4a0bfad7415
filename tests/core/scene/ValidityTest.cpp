#include "core/scene/Validity.h"

#include <gtest/gtest.h>

#include <set>

namespace asperity {
namespace {

TEST(Validity, NamesOnlyWhatIsSet) {
    ValidityFlags flags;
    EXPECT_EQ(validityText(flags), "-");
    flags.set(Validity::OutsideScan, true);
    flags.set(Validity::LargeContact, true);
    flags.set(Validity::FilledPixel, false);
    EXPECT_EQ(validityText(flags), "large_contact|outside_scan");
    EXPECT_FALSE(flags.has(Validity::FilledPixel));
}

TEST(Validity, EveryFlagHasItsOwnName) {
    std::set<std::string> names;
    for (unsigned i = 0; i < kValidityFlagCount; ++i) {
        names.insert(validityName(static_cast<Validity>(1U << i)));
    }
    EXPECT_EQ(names.size(), static_cast<std::size_t>(kValidityFlagCount));
    EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace asperity
