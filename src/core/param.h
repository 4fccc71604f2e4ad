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

/// What kind of value a parameter takes. Texts, one or a list, are for options alone: methods have
/// values that a search can turn.
enum class ParamKind { real, integer, flag, choice, text, list };

/// One row of a `Param` table as everyone but the method sees it: command line, TOML, tuner, rows,
/// docs.
///
/// Every value but a text travels as a double: a flag is 0 or 1, a choice is its index in
/// `choices`.
struct Param {
    std::string name = {};
    ParamKind kind = ParamKind::real;
    double min = 0;                         ///< inclusive; 0 for flags and choices
    double max = 0;                         ///< inclusive; 1 for flags, last index for choices
    double default_value = 0;               ///< read from the default-constructed parameter struct
    std::vector<std::string> choices = {};  ///< spellings, for `choice`; names, for some lists
    std::string unit = {};                  ///< "px", "deg", ... or "" where there is none
    std::string doc = {};                   ///< one sentence

    [[nodiscard]] bool is_number() const {
        return kind == ParamKind::real || kind == ParamKind::integer;
    }
};

/// Settings as the user spells them: name to text. Ordered, so that it prints the same everywhere.
using ParamValues = std::map<std::string, std::string>;

/// A value as somebody gave it, and where: an option, or a line of a file.
struct GivenText {
    std::string text;
    std::string where;
};

/// The double that `text` means for `param`.
///
/// Throws Error (where = `where`) that names the range or the choices if it means nothing.
[[nodiscard]] double parse_param(const Param& param, std::string_view text, std::string_view where);

/// The same; messages call the parameter `called`: "measure.crease_deg", "it".
[[nodiscard]] double parse_param(const Param& param,
                                 const GivenText& given,
                                 std::string_view called);

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
/// initialiser), one range and one sentence. A field is a pointer to a member, or a function that
/// returns a reference into a `P`. Fields may be double, float, integer, bool or an enum whose
/// values are 0..n-1.
template <class P>
class ParamTable {
  public:
    /// A number, `min..max` inclusive.
    template <class Field>
    ParamTable& number(Field field,
                       std::string name,
                       std::pair<double, double> range,
                       std::string unit,
                       std::string doc) {
        using F = FieldOf<Field>;
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
    template <class Field>
    ParamTable& flag(Field field, std::string name, std::string doc) {
        static_assert(std::is_same_v<FieldOf<Field>, bool>);
        return add({std::move(name), ParamKind::flag, 0, 1, 0, {}, "", std::move(doc)}, field);
    }

    /// One of several spellings; the values of the field, an enum or a bool, are the indices of
    /// `choices`.
    template <class Field>
    ParamTable& choice(Field field,
                       std::string name,
                       std::vector<std::string> choices,
                       std::string doc) {
        using F = FieldOf<Field>;
        static_assert(std::is_enum_v<F> || std::is_same_v<F, bool>);
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

    /// One text (kind text) or several (list), which `store(P&, const std::vector<GivenText>&)`
    /// reads and checks, and `load(const P&)` gives back. A list with choices holds these alone;
    /// `unit` is how help calls a text.
    template <class Store, class Load>
    ParamTable& texts(Param param, Store store, Load load) {
        params_.push_back(std::move(param));
        rows_.push_back({[store](P& p, const std::vector<GivenText>& given, std::string_view) {
                             store(p, given);
                         },
                         load});
        return *this;
    }

    [[nodiscard]] const std::vector<Param>& params() const { return params_; }

    /// Puts what was given into the field of row `i`. Throws Error (where = the text's) if it means
    /// nothing; the message calls the parameter `called`.
    void set(P& p,
             std::size_t i,
             const std::vector<GivenText>& given,
             std::string_view called) const {
        rows_[i].store(p, given, called);
    }
    /// The value of row `i` as text; a list's values one by one.
    [[nodiscard]] std::vector<std::string> get(const P& p, std::size_t i) const {
        return rows_[i].load(p);
    }

    /// A `P` with its defaults, overwritten by `values`.
    ///
    /// Throws Error for an unknown name, or a value outside its range; `where` says whose they are.
    [[nodiscard]] P read(const ParamValues& values, std::string_view where) const {
        check_known_params(params_, values, where);
        P result{};
        for (std::size_t i = 0; i < params_.size(); ++i) {
            const auto found = values.find(params_[i].name);
            if (found == values.end()) continue;
            set(result, i, {{found->second, std::string(where)}}, "parameter " + params_[i].name);
        }
        return result;
    }

    /// Every parameter of `p` as text, so that a row can be reproduced from its own columns.
    [[nodiscard]] ParamValues write(const P& p) const {
        ParamValues values;
        for (std::size_t i = 0; i < params_.size(); ++i)
            values[params_[i].name] = get(p, i).front();
        return values;
    }

  private:
    template <class Field>
    using FieldOf = std::remove_reference_t<std::invoke_result_t<Field, P&>>;

    struct Row {
        std::function<void(P&, const std::vector<GivenText>&, std::string_view called)> store;
        std::function<std::vector<std::string>(const P&)> load;
    };

    template <class Field>
    ParamTable& add(Param param, Field field) {
        using F = FieldOf<Field>;
        const P defaults{};
        param.default_value = static_cast<double>(std::invoke(field, defaults));
        params_.push_back(param);
        rows_.push_back(
            {[field, param](P& p, const std::vector<GivenText>& given, std::string_view called) {
                 const double value = parse_param(param, given.back(), called);
                 if constexpr (std::is_enum_v<F>) {
                     std::invoke(field, p) = static_cast<F>(static_cast<int>(value));
                 } else {
                     std::invoke(field, p) = static_cast<F>(value);
                 }
             },
             [field, param](const P& p) -> std::vector<std::string> {
                 return {format_param(param, static_cast<double>(std::invoke(field, p)))};
             }});
        return *this;
    }

    std::vector<Param> params_;
    std::vector<Row> rows_;
};

}  // namespace ink::core
