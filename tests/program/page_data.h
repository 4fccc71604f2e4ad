#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace ink::program {

/// What a page of `inkbench report` shows: the JSON that its scripts read. A test fails by the
/// exception where the page holds none.
inline nlohmann::json page_data(const std::string& page) {
    const std::string open = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

/// The table of that name of the page's first run; null if it has none.
inline nlohmann::json page_table(const std::string& page, const std::string& name) {
    return page_data(page)["runs"][0]["tables"].value(name, nlohmann::json());
}

}  // namespace ink::program
