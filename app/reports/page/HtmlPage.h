#pragma once

#include "app/reports/page/ReportPage.h"

#include <string>
#include <string_view>

namespace asperity {

/// A text as HTML and XML show it, printable and without markup; also within quotes.
[[nodiscard]] std::string escaped(std::string_view text);

/// The page as one file that needs no other: HTML that is XML, too, pictures and style in it. Light
/// or dark as the reader's system is, light on paper. Links lead to files beside it.
[[nodiscard]] std::string htmlPage(const ReportPage& page);

}  // namespace asperity
