#pragma once

#include "app/window/scene/OpenControl.h"
#include "tests/app/window/WindowFixture.h"
#include "tests/support/UserClicks.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {
class OpenDialog;
}

namespace asperity::test {

/// A user who opens a real scan by the dialog, levels it and touches it, click by click.
class ScanWalk : public Window {
protected:
    void SetUp() override;

    /// @param file relative to ../shared/data/afm
    void openScan(const std::string& file);
    /// Adds a step to the leveling, and opens the scan.
    void levelAndOpen();
    void engage();
    void withdraw();
    void startRecording();
    /// @return its folder
    std::filesystem::path stopRecording();
    /// What the banner has said of the tip since the scan is open, without repetition.
    [[nodiscard]] const std::vector<std::string>& saidOfTip() const { return saidOfTip_; }
    void expectNothingToRead();

    UserClicks user;

private:
    OpenDialog& dialog() { return *stage.get<OpenControl>().dialog(); }
    void clickFile();
    void watch();
    void look();

    std::string name_;  ///< of the scan's copy
    std::vector<std::string> saidOfTip_;
};

}  // namespace asperity::test
