// New here, after item buffers (Weghorst, Hooper and Greenberg 1984): triangle ids, and the line
// between two that differ looked up in the mesh, with its class.

#include "methods/id_lookup/id_lookup.h"

namespace ink::methods {

core::ParamTable<IdLookup::Params> IdLookup::table() {
    core::ParamTable<Params> table;
    add_lookup_params(table);
    buffers::add_depth_format_param(buffers::add_samples_param(table));
    return method::add_threshold_of_two(table);
}

method::MethodInfo id_lookup_method() {
    return method::method_info<IdLookup>("id_lookup");
}

}  // namespace ink::methods
