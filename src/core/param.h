#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ink::core {

/// What kind of value a parameter takes.
enum class ParamKind { real, integer, flag, choice };

/// One row of a `Param` table as everyone but the method sees it: command line, TOML, tuner, rows,
/// docs.
///
/// Every value travels as a double: a flag is 0 or 1, a choice is its index in `choices`.
struct Param {
    std::string name;
    ParamKind kind = ParamKind::real;
    double min = 0;                    ///< inclusive; 0 for flags and choices
    double max = 0;                    ///< inclusive; 1 for flags, last index for choices
    double default_value = 0;          ///< read from the default-constructed parameter struct
    std::vector<std::string> choices;  ///< spellings, for `choice` only
    std::string unit;                  ///< "px", "deg", ... or "" where there is none
    std::string doc;                   ///< one sentence
};

/// Settings as the user spells them: name to text. Ordered, so that it prints the same everywhere.
using ParamValues = std::map<std::string, std::string>;

/// The double that `text` means for `param`.
///
/// Throws Error (where = `where`) that names the range or the choices if it means nothing.
[[nodiscard]] double parse_param(const Param& param, std::string_view text, std::string_view where);

/// The text that `parse_param` reads back to `value`; shortest form that round-trips.
[[nodiscard]] std::string format_param(const Param& param, double value);

/// The accepted values of `param` in words: "0..255", "absolute | positive | wrap", "true | false".
[[nodiscard]] std::string accepted_values(const Param& param);

/// Throws Error if `values` holds a name that no row of `params` has; the message lists the known
/// ones and the nearest spelling.
void check_known_params(const std::vector<Param>& params,
                        const ParamValues& values,
                        std::string_view where);

/// `names` joined by commas, with the nearest one suggested if `wrong` is at most two edits from
/// it.
///
/// The "accepted" half of every message about an unknown name: parameter, method, scene, column.
[[nodiscard]] std::string known_names(const std::vector<std::string>& names,
                                      std::string_view wrong);

/// The parameters of one parameter struct `P`, in the order they are shown.
///
/// Each row binds a name to a field of `P`, so a parameter has one default (the field's
/// initialiser), one range and one sentence. Fields may be double, float, int, bool or an enum
/// whose values are 0..n-1.
template <class P>
class ParamTable {
  public:
    /// A number: double, float or int field, `min..max` inclusive.
    template <class F, class Base>
    ParamTable& number(F Base::*field,
                       std::string name,
                       std::pair<double, double> range,
                       std::string unit,
                       std::string doc) {
        static_assert(std::is_arithmetic_v<F> && !std::is_same_v<F, bool>);
        const auto kind = std::is_integral_v<F> ? ParamKind::integer : ParamKind::real;
        return add({std::move(name),
                    kind,
                    range.first,
                    range.second,
                    0,
                    {},
                    std::move(unit),
                    std::move(doc)},
                   field);
    }

    /// A yes or no.
    template <class Base>
    ParamTable& flag(bool Base::*field, std::string name, std::string doc) {
        return add({std::move(name), ParamKind::flag, 0, 1, 0, {}, "", std::move(doc)}, field);
    }

    /// One of several spellings; the enum's values are the indices of `choices`.
    template <class F, class Base>
    ParamTable& choice(F Base::*field,
                       std::string name,
                       std::vector<std::string> choices,
                       std::string doc) {
        static_assert(std::is_enum_v<F>);
        const auto last = static_cast<double>(choices.size() - 1);
        return add({std::move(name),
                    ParamKind::choice,
                    0,
                    last,
                    0,
                    std::move(choices),
                    "",
                    std::move(doc)},
                   field);
    }

    [[nodiscard]] const std::vector<Param>& params() const { return params_; }

    /// A `P` with its defaults, overwritten by `values`.
    ///
    /// Throws Error for an unknown name, or a value outside its range; `where` says whose they are.
    [[nodiscard]] P read(const ParamValues& values, std::string_view where) const {
        check_known_params(params_, values, where);
        P result{};
        for (std::size_t i = 0; i < params_.size(); ++i) {
            const auto found = values.find(params_[i].name);
            if (found != values.end()) {
                store_[i](result, parse_param(params_[i], found->second, where));
            }
        }
        return result;
    }

    /// Every parameter of `p` as text, so that a row can be reproduced from its own columns.
    [[nodiscard]] ParamValues write(const P& p) const {
        ParamValues values;
        for (std::size_t i = 0; i < params_.size(); ++i) {
            values[params_[i].name] = format_param(params_[i], load_[i](p));
        }
        return values;
    }

  private:
    template <class F, class Base>
    ParamTable& add(Param param, F Base::*field) {
        static_assert(std::is_base_of_v<Base, P>);
        store_.push_back([field](P& p, double v) {
            if constexpr (std::is_enum_v<F>) {
                p.*field = static_cast<F>(static_cast<int>(v));
            } else {
                p.*field = static_cast<F>(v);
            }
        });
        load_.push_back([field](const P& p) { return static_cast<double>(p.*field); });
        param.default_value = load_.back()(P{});
        params_.push_back(std::move(param));
        return *this;
    }

    std::vector<Param> params_;
    std::vector<std::function<void(P&, double)>> store_;
    std::vector<std::function<double(const P&)>> load_;
};

}  // namespace ink::core
