#include "ui/NumberText.h"
#include "ui/Theme.h"
#include "vtkplugins/pictures/Display.h"

#include <QApplication>

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

namespace {

/// The program's QApplication; made before the first test, not when tests are merely listed.
class GuiEnvironment : public ::testing::Environment {
public:
    GuiEnvironment(int& argc, char** argv) : argc_(argc), argv_(argv) {}

    void SetUp() override {
        if (asperity::haveDisplay()) {
            application_ = std::make_unique<QApplication>(argc_, argv_);
            asperity::keepDecimalPoint();
            asperity::applyTheme();
            return;
        }
        const char* ci = std::getenv("CI");  // NOLINT(concurrency-mt-unsafe): no threads yet
        if (ci != nullptr && std::string(ci) == "true") {
            FAIL() << "CI=true, but no X display answers";
        }
        GTEST_SKIP() << "SKIPPED: no X display answers (run under xvfb-run)";
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
