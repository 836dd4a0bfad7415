#pragma once

#include "vtkplugins/pictures/RasterImage.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>

namespace asperity::test {

inline constexpr PictureSize kSize{1200, 750};

inline std::string bytesOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A picture read back.
class Image {
public:
    explicit Image(const std::filesystem::path& path) {
        reader_->SetFileName(path.c_str());
        reader_->Update();
    }

    [[nodiscard]] int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
    [[nodiscard]] int height() const { return reader_->GetOutput()->GetDimensions()[1]; }
    [[nodiscard]] std::array<int, 3> at(int x, int y) const {
        const auto* rgb =
            static_cast<const unsigned char*>(reader_->GetOutput()->GetScalarPointer(x, y, 0));
        return {rgb[0], rgb[1], rgb[2]};
    }
    [[nodiscard]] std::size_t colors() const {
        std::set<std::array<int, 3>> found;
        count([&found](const std::array<int, 3>& rgb) { return found.insert(rgb).second; });
        return found.size();
    }
    int count(const std::function<bool(const std::array<int, 3>&)>& wanted) const {
        int found = 0;
        for (int y = 0; y < height(); ++y) {
            for (int x = 0; x < width(); ++x) {
                found += wanted(at(x, y)) ? 1 : 0;
            }
        }
        return found;
    }
    /// Whether the outermost pixels are all paper: nothing is cut off.
    [[nodiscard]] bool hasCleanEdge() const {
        constexpr int kEdge = 4;
        const std::array<int, 3> paper{255, 255, 255};
        for (int y = 0; y < height(); ++y) {
            for (int x = 0; x < width(); ++x) {
                const bool inner =
                    x >= kEdge && y >= kEdge && x < width() - kEdge && y < height() - kEdge;
                if (!inner && at(x, y) != paper) {
                    return false;
                }
            }
        }
        return true;
    }

private:
    vtkNew<vtkPNGReader> reader_;
};

class Pictures : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::path(testing::TempDir()) /
                 ("asperity_pictures_" +
                  std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    /// Draws twice and checks what every picture must be.
    Image drawn(const std::function<void(const std::filesystem::path&)>& write) const {
        write(folder / "first.png");
        write(folder / "second.png");
        EXPECT_EQ(bytesOf(folder / "first.png"), bytesOf(folder / "second.png"));
        Image image(folder / "first.png");
        EXPECT_EQ(image.width(), kSize.width);
        EXPECT_EQ(image.height(), kSize.height);
        EXPECT_TRUE(image.hasCleanEdge());
        return image;
    }

    std::filesystem::path folder;
};

}  // namespace asperity::test
