// New here: labels of smooth patches in a byte. Those that meet at a border differ, others by
// chance (surface_codes/surface_codes.h); any difference between a pixel's samples is a line.

#include "methods/surface_codes/code_method.h"

namespace ink::methods {
namespace {

class Label8 : public CodeMethod {
  public:
    using Params = CodeParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        return method::add_threshold_of_two(add_code_params(table));
    }
    explicit Label8(const Params& params) : CodeMethod(params, label_setup()) {}
};

}  // namespace

method::MethodInfo label8_method() {
    return method::method_info<Label8>("label8");
}

}  // namespace ink::methods
