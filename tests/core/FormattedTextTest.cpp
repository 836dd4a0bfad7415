#include "core/FormattedText.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(FormattedText, IsWhatPrintfPrints) {
    EXPECT_EQ(formatted("%s at %.3g nm, %d %%", "snap-in", -0.4944, 7),
              "snap-in at -0.494 nm, 7 %");
}

TEST(FormattedText, EndsAfter511Bytes) {
    const std::string text(1000, 'a');
    EXPECT_EQ(formatted("%s", text.c_str()), text.substr(0, 511));
}

}  // namespace
}  // namespace asperity
