#include "method/family.h"

namespace ink::method {

std::string_view name_of(Family family) {
    switch (family) {
        case Family::packed:
            return "packed";
        case Family::full_buffers:
            return "full_buffers";
        case Family::ids:
            return "ids";
        case Family::edges_and_hulls:
            return "edges_and_hulls";
        case Family::other:
            break;
    }
    return "other";
}

std::string_view label_of(Family family) {
    switch (family) {
        case Family::full_buffers:
            return "full buffers";
        case Family::edges_and_hulls:
            return "edges, hulls";
        case Family::packed:
        case Family::ids:
        case Family::other:
            break;
    }
    return name_of(family);
}

std::string_view name_of(Marker marker) {
    switch (marker) {
        case Marker::circle:
            return "circle";
        case Marker::square:
            return "square";
        case Marker::diamond:
            return "diamond";
        case Marker::up:
            return "up";
        case Marker::down:
            return "down";
        case Marker::plus:
            return "plus";
        case Marker::cross:
            return "cross";
        case Marker::left:
            return "left";
        case Marker::right:
            return "right";
    }
    return "circle";
}

}  // namespace ink::method
