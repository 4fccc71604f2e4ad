#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
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
    std::optional<double> number = {};  ///< of one who has it as a number; `text` is for messages
};

/// The double that `text`, or a given number, means for `param`.
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

/// What the row of a number, flag or choice knows of its field: where it lies in its struct, what
/// it is there by default, and how it becomes a double and back.
struct ParamField {
    std::ptrdiff_t offset = 0;
    void* (*find)(void* whole) = nullptr;  ///< instead of `offset`, of a field that code finds
    double (*load)(const void* field) = nullptr;
    void (*store)(void* field, double value) = nullptr;
    double default_value = 0;
};

/// The rows of a table without the type of its struct, so that they are compiled once and not for
/// each struct. A `void*` is a struct of the table's type.
class ParamRows {
  public:
    using Store = std::function<void(void*, const std::vector<GivenText>&)>;
    using Load = std::function<std::vector<std::string>(const void*)>;

    ParamRows();
    ParamRows(const ParamRows&);
    ParamRows& operator=(const ParamRows&) = delete;
    ~ParamRows();

    void add_number(const ParamField& field,
                    ParamKind kind,
                    std::string_view name,
                    std::pair<double, double> range,
                    std::string_view unit,
                    std::string_view doc);
    void add_flag(const ParamField& field, std::string_view name, std::string_view doc);
    void add_choice(const ParamField& field,
                    std::string_view name,
                    std::span<const std::string_view> choices,
                    std::string_view doc);
    void add_texts(Param param, Store store, Load load);

    [[nodiscard]] const std::vector<Param>& params() const { return params_; }
    void set(void* whole,
             std::size_t i,
             const std::vector<GivenText>& given,
             std::string_view called) const;
    [[nodiscard]] std::vector<std::string> get(const void* whole, std::size_t i) const;
    void read(void* whole, const ParamValues& values, std::string_view where) const;
    [[nodiscard]] ParamValues complete(const ParamValues& values, std::string_view where) const;

  private:
    struct Row {
        ParamField field;
        Store store;  ///< of texts alone
        Load load;    ///< as `store`
    };

    void add(Param param, const ParamField& field);

    std::vector<Param> params_;
    std::vector<Row> rows_;
};

/// The parameters of one parameter struct `P`, in the order they are shown.
///
/// Each row binds a name to a field of `P`, so a parameter has one default (the field's
/// initialiser), one range and one sentence. A field is a pointer to a member, or a function
/// without captures that returns a reference into a `P`. Fields may be double, integer, bool or an
/// enum whose values are 0..n-1.
template <class P>
class ParamTable {
  public:
    /// A number, `min..max` inclusive.
    template <class Field>
    ParamTable& number(Field field,
                       std::string_view name,
                       std::pair<double, double> range,
                       std::string_view unit,
                       std::string_view doc) {
        using F = FieldOf<Field>;
        static_assert(std::is_same_v<F, double> ||
                      (std::is_integral_v<F> && !std::is_same_v<F, bool>));
        const auto kind = std::is_integral_v<F> ? ParamKind::integer : ParamKind::real;
        rows_.add_number(row_field(field), kind, name, range, unit, doc);
        return *this;
    }

    /// A yes or no.
    template <class Field>
    ParamTable& flag(Field field, std::string_view name, std::string_view doc) {
        static_assert(std::is_same_v<FieldOf<Field>, bool>);
        rows_.add_flag(row_field(field), name, doc);
        return *this;
    }

    /// One of several spellings; the values of the field, an enum or a bool, are the indices of
    /// `choices`.
    template <class Field>
    ParamTable& choice(Field field,
                       std::string_view name,
                       std::span<const std::string_view> choices,
                       std::string_view doc) {
        using F = FieldOf<Field>;
        static_assert(std::is_enum_v<F> || std::is_same_v<F, bool>);
        rows_.add_choice(row_field(field), name, choices, doc);
        return *this;
    }
    template <class Field>
    ParamTable& choice(Field field,
                       std::string_view name,
                       std::initializer_list<std::string_view> choices,
                       std::string_view doc) {
        return choice(field, name, std::span(choices.begin(), choices.size()), doc);
    }

    /// One text (kind text) or several (list), which `store(P&, const std::vector<GivenText>&)`
    /// reads and checks, and `load(const P&)` gives back. A list with choices holds these alone;
    /// `unit` is how help calls a text.
    template <class StoreTexts, class LoadTexts>
    ParamTable& texts(Param param, StoreTexts store, LoadTexts load) {
        rows_.add_texts(
            std::move(param),
            [store](void* p, const std::vector<GivenText>& given) {
                store(*static_cast<P*>(p), given);
            },
            [load](const void* p) { return load(*static_cast<const P*>(p)); });
        return *this;
    }

    [[nodiscard]] const ParamRows& rows() const { return rows_; }
    [[nodiscard]] const std::vector<Param>& params() const { return rows_.params(); }

    /// Puts what was given into the field of row `i`. Throws Error (where = the text's) if it means
    /// nothing; the message calls the parameter `called`.
    void set(P& p,
             std::size_t i,
             const std::vector<GivenText>& given,
             std::string_view called) const {
        rows_.set(&p, i, given, called);
    }
    /// The value of row `i` as text; a list's values one by one.
    [[nodiscard]] std::vector<std::string> get(const P& p, std::size_t i) const {
        return rows_.get(&p, i);
    }

    /// A `P` with its defaults, overwritten by `values`.
    ///
    /// Throws Error for an unknown name, or a value outside its range; `where` says whose they are.
    [[nodiscard]] P read(const ParamValues& values, std::string_view where) const {
        P result{};
        rows_.read(&result, values, where);
        return result;
    }

    /// Every parameter of what read() gives as text, so that a row can be reproduced from its own
    /// columns. Throws as read() does. Not for tables with texts.
    [[nodiscard]] ParamValues complete(const ParamValues& values, std::string_view where) const {
        return rows_.complete(values, where);
    }

  private:
    template <class Field>
    using FieldOf = std::remove_reference_t<std::invoke_result_t<Field, P&>>;

    template <class Field>
    [[nodiscard]] ParamField row_field(Field field) const {
        using F = FieldOf<Field>;
        const F& in_defaults = std::invoke(field, defaults_);
        ParamField erased;
        if constexpr (std::is_member_pointer_v<Field>) {
            erased.offset = reinterpret_cast<const char*>(&in_defaults) -
                            reinterpret_cast<const char*>(&defaults_);
        } else {
            erased.find = [](void* p) -> void* { return &Field{}(*static_cast<P*>(p)); };
        }
        erased.load = [](const void* at) {
            return static_cast<double>(*static_cast<const F*>(at));
        };
        erased.store = [](void* at, double value) { *static_cast<F*>(at) = static_cast<F>(value); };
        erased.default_value = static_cast<double>(in_defaults);
        return erased;
    }

    P defaults_{};
    ParamRows rows_;
};

}  // namespace ink::core
