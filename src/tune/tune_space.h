#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/param.h"
#include "method/method.h"

namespace ink::tune {

/// How a parameter's range is laid out over 0..1, so that a step of the search means as much
/// everywhere.
enum class ParameterScale {
    linear,
    log,      ///< ranges above 0 whose ends are a factor of 50 apart or more
    sym_log,  ///< asinh: ranges with 0 in them that are a thousand wide or more
};

/// A parameter as the tuner sees it.
struct TunedParameter {
    core::Param param;
    double low = 0;  ///< inclusive, as high is: the param's own ends unless the user narrowed them
    double high = 0;
    ParameterScale scale = ParameterScale::linear;
};

/// The settings among which a method is tuned: points of the unit cube, an axis per parameter.
///
/// Reals are linear, logarithmic or both ways logarithmic over their range and come rounded to four
/// digits; whole numbers are rounded, flags and choices go by their index. Settings beyond a sum
/// limit are scaled down to it, so that every point of the cube is a setting and every setting
/// within the limit has a point.
class TuneSpace {
  public:
    /// `parameters` is a comma list of parameters, each `name` or `name=low..high`; "" is what the
    /// method is tuned in unless somebody says otherwise (default_parameters). Throws core::Error
    /// (where =
    /// "--params") for an unknown parameter, one named twice, a range that is none or exceeds the
    /// parameter's.
    TuneSpace(const method::MethodInfo& method, const std::string& parameters);

    [[nodiscard]] std::size_t size() const { return parameters_.size(); }
    [[nodiscard]] const std::vector<TunedParameter>& parameters() const { return parameters_; }
    /// Whether `name` is one of the parameters.
    [[nodiscard]] bool has(const std::string& name) const;

    /// The settings at `point`, each coordinate taken into 0..1 first.
    [[nodiscard]] core::ParamValues settings_at(const std::vector<double>& point) const;
    /// The point of `settings`, which hold every parameter; values outside the range are taken to
    /// its end.
    [[nodiscard]] std::vector<double> point_of(const core::ParamValues& settings) const;

  private:
    std::vector<TunedParameter> parameters_;
    std::vector<method::SumLimit> limits_;
};

/// The parameters that a method is tuned in unless somebody says otherwise, as a list for
/// TuneSpace: its tunables, its threshold if it has none.
[[nodiscard]] std::string default_parameters(const method::MethodInfo& method);

}  // namespace ink::tune
