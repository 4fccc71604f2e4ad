#pragma once

#include "buffers/codes/code_method.h"

namespace ink::methods {

/// Labels of smooth patches in a byte: those that meet at a border differ, others by chance.
class Label8 : public buffers::CodeMethod {
  public:
    using Params = buffers::CodeParams;
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit Label8(const Params& params);
};

[[nodiscard]] method::MethodInfo label8();

}  // namespace ink::methods
