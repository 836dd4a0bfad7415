#pragma once

#include <filesystem>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace asperity::test {

/// A page of a report, read back from its HTML.
class ReportedPage {
public:
    /// Fails the calling test where the file is no XML.
    explicit ReportedPage(const std::filesystem::path& html);

    /// All that a reader sees, with usual spaces.
    [[nodiscard]] std::string text() const;
    /// The cells of the column that begins so, of the first table that has one.
    [[nodiscard]] std::vector<std::string> column(const std::string& title) const;
    /// Returns the text beside a name in a list of names and values; empty: it is not there.
    [[nodiscard]] std::string fact(const std::string& name) const;
    /// Files that links lead to.
    [[nodiscard]] std::vector<std::string> links() const;
    [[nodiscard]] std::size_t count(const char* xpath) const;
    /// The unit in brackets behind the title of a column, as a factor to SI.
    [[nodiscard]] double unitOf(const std::string& title) const;

private:
    [[nodiscard]] pugi::xml_node titleCell(const std::string& title) const;

    pugi::xml_document page_;
};

/// A value as a page shows it: "3.395 ± 0.086".
struct ShownValue {
    double value = 0.0;
    double rounding = 0.0;        ///< half of its last digit
    std::optional<double> sigma;  ///< none: not shown
    double sigmaRounding = 0.0;
};

/// Nothing where the cell says that there is no value.
[[nodiscard]] std::optional<ShownValue> shownValue(const std::string& cell);

}  // namespace asperity::test
