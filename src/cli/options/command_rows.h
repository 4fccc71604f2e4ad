#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/param.h"

namespace ink::cli {

inline constexpr std::pair<double, double> kAnyNumber{-std::numeric_limits<double>::infinity(),
                                                      std::numeric_limits<double>::infinity()};

/// How messages call an option that is spelt "-o,--out": "--out".
[[nodiscard]] std::string called(const std::string& spellings);

/// The options of a command as a table: what each is called, the field it goes to, what it takes,
/// what it means. Help shows as default what a field has.
///
/// Numbers and choices are read as rows of core::ParamTable are: while the command line is parsed,
/// text that means nothing throws core::Error (where = the option) with what is accepted.
class CommandRows {
  public:
    explicit CommandRows(CLI::App& command) : command_(command) {}

    CLI::Option* flag(const std::string& name, bool& to, const std::string& doc) {
        return command_.add_flag(name, to, doc);
    }

    /// A text or a path, or one that may be left out; `unit` is how help calls it.
    template <class Text>
    CLI::Option* text(const std::string& name,
                      Text& to,
                      const std::string& unit,
                      const std::string& doc) {
        CLI::Option* option = command_.add_option(name, to, doc)->type_name(unit);
        if constexpr (std::is_same_v<Text, std::string>) option->capture_default_str();
        return option;
    }

    /// A text that may be given again.
    CLI::Option* list(const std::string& name,
                      std::vector<std::string>& to,
                      const std::string& unit,
                      const std::string& doc) {
        return command_.add_option(name, to, doc)
            ->type_name(unit)
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    }

    /// A number, `min..max` inclusive, or one that may be left out.
    template <class Number>
    CLI::Option* number(const std::string& name,
                        Number& to,
                        std::pair<double, double> range,
                        const std::string& unit,
                        const std::string& doc) {
        using Bare = typename Unwrapped<Number>::Type;
        core::Param param{
            .name = name,
            .kind = std::is_integral_v<Bare> ? core::ParamKind::integer : core::ParamKind::real,
            .min = range.first,
            .max = range.second,
            .unit = unit,
            .doc = doc};
        std::string usual;
        if constexpr (std::is_same_v<Bare, Number>) usual = fmt::format("{}", to);
        return value(std::move(param), usual, [&to](double v) { to = static_cast<Bare>(v); });
    }

    /// One of several words: a text, or an enum or bool whose values are their indices.
    template <class Choice>
    CLI::Option* choice(const std::string& name,
                        Choice& to,
                        std::vector<std::string> words,
                        const std::string& doc) {
        core::Param param{.name = name, .kind = core::ParamKind::choice, .doc = doc};
        param.choices = std::move(words);
        if constexpr (std::is_same_v<Choice, std::string>) {
            return value(param, to, [&to, param](double v) { to = core::format_param(param, v); });
        } else {
            const std::string usual = core::format_param(param, static_cast<double>(to));
            return value(param, usual, [&to](double v) { to = static_cast<Choice>(v); });
        }
    }

  private:
    template <class Number>
    struct Unwrapped {
        using Type = Number;
    };
    template <class Number>
    struct Unwrapped<std::optional<Number>> {
        using Type = Number;
    };

    CLI::Option* value(core::Param param,
                       const std::string& usual,
                       const std::function<void(double)>& store);

    CLI::App& command_;
};

}  // namespace ink::cli
