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

TEST(Validity, EveryFlagHasItsOwnKeyAndWords) {
    std::set<std::string> keys{""};
    std::set<std::string> words{""};
    std::set<std::string> briefs{""};
    for (const ValidityTraits& one : kValidityTraits) {
        keys.insert(one.key);
        words.insert(one.words);
        briefs.insert(one.brief);
        EXPECT_LE(std::string(one.brief).size(), 24U) << one.brief;
    }
    EXPECT_EQ(keys.size(), 1 + kValidityFlagCount);
    EXPECT_EQ(words.size(), 1 + kValidityFlagCount);
    EXPECT_EQ(briefs.size(), 1 + kValidityFlagCount);
}

TEST(FlagOrder, HasEveryFlagOnce) {
    ValidityFlags found;
    for (const Validity flag : kFlagsByEffect) {
        EXPECT_FALSE(found.has(flag)) << traitsOf(flag).key;
        EXPECT_EQ(traitsOf(flag).flag, flag);
        found.set(flag, true);
    }
}

}  // namespace
}  // namespace asperity
