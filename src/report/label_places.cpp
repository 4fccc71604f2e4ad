#include "report/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ink::report {
namespace {

double overlap(const Box& a, const Box& b) {
    const double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    const double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    return std::max(0.0, width) * std::max(0.0, height);
}

double overlap(const Box& box, const std::vector<Box>& others) {
    double area = 0;
    for (const Box& other : others)
        area += overlap(box, other);
    return area;
}

bool contains(const Box& outer, const Box& inner) {
    return inner.x >= outer.x && inner.y >= outer.y &&
           inner.x + inner.width <= outer.x + outer.width &&
           inner.y + inner.height <= outer.y + outer.height;
}

/// The nearest point of `box` to (x, y) is this far away.
double distance(const Box& box, double x, double y) {
    const double dx = std::max({box.x - x, 0.0, x - box.x - box.width});
    const double dy = std::max({box.y - y, 0.0, y - box.y - box.height});
    return std::hypot(dx, dy);
}

/// Indices of `named`, those with the most others close by first.
std::vector<std::size_t> crowded_first(const std::vector<Named>& named) {
    std::vector<double> crowding(named.size());
    for (std::size_t i = 0; i < named.size(); ++i) {
        for (const Named& other : named)
            crowding[i] += 1 / (30 + std::hypot(other.x - named[i].x, other.y - named[i].y));
    }
    std::vector<std::size_t> order(named.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return crowding[a] > crowding[b];
    });
    return order;
}

/// Boxes round a marker, the usual places first.
std::vector<Box> candidates(const Named& at, double width, double height, double radius) {
    std::vector<Box> boxes;
    constexpr int kDirections = 24;
    for (double away = radius + 2; away < 170; away += away < 30 ? 4 : 8) {
        for (int i = 0; i < kDirections; ++i) {
            const double angle = 2 * 3.14159265358979 * i / kDirections;
            // The box touches the circle of this radius with the side that faces the marker.
            const double cx = at.x + std::cos(angle) * (away + width / 2);
            const double cy = at.y + std::sin(angle) * (away + height / 2);
            boxes.push_back({cx - width / 2, cy - height / 2, width, height});
        }
    }
    return boxes;
}

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<Named>& named, const LabelRoom& room) {
    std::vector<Box> taken = room.taken;
    for (const Named& n : named)
        taken.push_back({n.x - room.radius, n.y - room.radius, 2 * room.radius, 2 * room.radius});
    std::vector<LabelPlace> places(named.size());
    for (const std::size_t i : crowded_first(named)) {
        const Named& n = named[i];
        const double width = text_width(n.name, room.size) + 2;
        double least = std::numeric_limits<double>::infinity();
        for (const Box& box : candidates(n, width, room.size + 2, room.radius)) {
            if (!contains(room.inside, box)) continue;
            const double away = distance(box, n.x, n.y);
            const double cost = 1000 * overlap(box, taken) + 0.35 * overlap(box, room.avoided) +
                                away + (away > 2.2 * room.radius ? 12 : 0);
            if (cost >= least) continue;
            least = cost;
            places[i] = {box, away > 2.2 * room.radius};
        }
        taken.push_back(places[i].box);
    }
    return places;
}

}  // namespace ink::report
