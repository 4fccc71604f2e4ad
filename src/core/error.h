#pragma once

#include <stdexcept>
#include <string>

namespace ink::core {

/// The one exception of the project: bad input, told so that the user can mend it.
///
/// `where` is the file, option or place; `what_happened` names the wrong value; `accepted` says
/// what would have been taken (may be empty). `what()` joins the three into one line, which the
/// program prints as it stands before it exits with code 2. A caller's bug is an assertion, never
/// an Error.
class Error : public std::runtime_error {
  public:
    Error(std::string where, std::string what_happened, std::string accepted = {})
        : std::runtime_error(
              in_one_line(where + ": " + what_happened +
                          (accepted.empty() ? std::string{} : " (accepted: " + accepted + ")"))),
          where_(std::move(where)),
          what_happened_(std::move(what_happened)),
          accepted_(std::move(accepted)) {}

    [[nodiscard]] const std::string& where() const { return where_; }
    [[nodiscard]] const std::string& what_happened() const { return what_happened_; }
    [[nodiscard]] const std::string& accepted() const { return accepted_; }

  private:
    [[nodiscard]] static std::string in_one_line(std::string text) {
        for (char& c : text) {
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
        }
        return text;
    }

    std::string where_;
    std::string what_happened_;
    std::string accepted_;
};

}  // namespace ink::core
