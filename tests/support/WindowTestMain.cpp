#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Display.h"

#include <QApplication>

#include <gtest/gtest.h>

#include <memory>

namespace {

/// The program's QApplication; made before the first test, not when tests are merely listed.
class GuiEnvironment : public ::testing::Environment {
public:
    GuiEnvironment(int& argc, char** argv) : argc_(argc), argv_(argv) {}

    void SetUp() override {
        ASSERT_TRUE(asperity::haveDisplay())
            << "no X display answers (tools/run_suite.py --display)";
        application_ = std::make_unique<QApplication>(argc_, argv_);
        asperity::keepDecimalPoint();
        asperity::applyTheme();
    }
    void TearDown() override { application_.reset(); }

private:
    int& argc_;
    char** argv_;
    std::unique_ptr<QApplication> application_;
};

}  // namespace

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    // GoogleTest takes the environment over.
    ::testing::AddGlobalTestEnvironment(new GuiEnvironment(argc, argv));
    return RUN_ALL_TESTS();
}
