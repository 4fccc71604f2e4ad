#include "method/family.h"

#include "core/vocabulary.h"

namespace ink::method {

std::string_view name_of(Family family) {
    return core::vocabulary().families[static_cast<std::size_t>(family)].name;
}

std::string_view name_of(Marker marker) {
    return core::vocabulary().markers[static_cast<std::size_t>(marker)].name;
}

}  // namespace ink::method
