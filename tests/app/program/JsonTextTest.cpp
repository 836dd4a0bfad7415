#include "app/program/JsonText.h"

#include "core/Error.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

// The library has an exception of its own for numbers; it got past all who expect an Error.
TEST(RequiredJson, ANumberThatNoneCanBeIsRefusedWithTheFilesName) {
    test::ScratchFolder scratch;
    const auto file = scratch.write("summary.json", R"({"input": {"size_x_m": -1e999}})");
    EXPECT_EQ(test::refusalOf([&] { (void)requiredJson(file); }),
              file.string() + ": a number in it is larger than any can be; the file is damaged");
    EXPECT_TRUE(readJson(file).is_discarded());
}

TEST(RequiredJson, WhatIsNoJsonIsRefusedWithTheByte) {
    test::ScratchFolder scratch;
    const auto file = scratch.write("summary.json", R"({"input": 3)");
    EXPECT_EQ(test::refusalOf([&] { (void)requiredJson(file); }),
              file.string() + ": byte 11: this is no JSON; the file is truncated or damaged");
}

}  // namespace
}  // namespace asperity
