#pragma once

#include "methods/mesh_lookup/lookup_method.h"

namespace ink::methods {

/// Triangle ids; every side between samples that differ is looked up in the mesh.
class IdLookup : public LookupMethod {
  public:
    using Params = LookupParams;
    [[nodiscard]] static core::ParamTable<Params> table();

    explicit IdLookup(const Params& params) : LookupMethod(params) {}
};

}  // namespace ink::methods
