#include "glb.h"

#include <cmath>
#include <cstring>
#include <sstream>

namespace brep {
namespace {

/// Bytes of a GLB's buffer, and the JSON of its views and accessors.
class Buffer {
  public:
    template <class T>
    int add(const std::vector<T>& items, int target) {
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        const std::size_t offset = bytes_.size();
        bytes_.resize(offset + items.size() * sizeof(T));
        std::memcpy(bytes_.data() + offset, items.data(), items.size() * sizeof(T));
        views_ << (count_ ? "," : "") << "{\"buffer\":0,\"byteOffset\":" << offset
               << ",\"byteLength\":" << items.size() * sizeof(T);
        if (target != 0) views_ << ",\"target\":" << target;
        views_ << "}";
        return count_++;
    }
    [[nodiscard]] std::string bytes() const {
        std::string padded = bytes_;
        padded.resize((padded.size() + 3) / 4 * 4);
        return padded;
    }
    [[nodiscard]] std::string views() const { return views_.str(); }

  private:
    std::string bytes_;
    std::ostringstream views_;
    int count_ = 0;
};

/// The value of each edge of each triangle: 2 hard, 3 hard and named before, 0 neither.
std::vector<std::uint8_t> visibility(const Part& part) {
    std::set<Segment> named;
    std::vector<std::uint8_t> packed((6 * part.triangles.size() + 7) / 8, 0);
    std::size_t i = 0;
    for (const auto& t : part.triangles)
        for (int side = 0; side < 3; ++side, ++i) {
            const Segment s = segment(t[side], t[(side + 1) % 3]);
            if (!part.hard.contains(s)) continue;
            const unsigned value = named.insert(s).second ? 2 : 3;
            packed[i / 4] |= static_cast<std::uint8_t>(value << (2 * (i % 4)));
        }
    return packed;
}

}  // namespace

std::string glb_of(const std::vector<Part>& parts) {
    constexpr int kVertices = 34962, kIndices = 34963;
    Buffer buffer;
    std::ostringstream accessors, meshes, nodes, list;
    int accessor = 0;
    for (std::size_t n = 0; n < parts.size(); ++n) {
        const Part& part = parts[n];
        std::vector<float> p;
        std::array<float, 3> low, high;
        low.fill(INFINITY), high.fill(-INFINITY);
        for (const gp_Pnt& point : part.points) {
            const std::array at{static_cast<float>(point.X()),
                                static_cast<float>(point.Z()),
                                static_cast<float>(-point.Y())};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], at[axis]);
                high[axis] = std::max(high[axis], at[axis]);
                p.push_back(at[axis]);
            }
        }
        std::vector<std::uint32_t> indices;
        for (const auto& t : part.triangles)
            indices.insert(indices.end(), t.begin(), t.end());
        const auto marks = visibility(part);
        const auto vec = [](const std::array<float, 3>& v) {
            std::ostringstream text;
            text.precision(9);
            text << "[" << v[0] << "," << v[1] << "," << v[2] << "]";
            return text.str();
        };
        const char* comma = n > 0 ? "," : "";
        accessors << comma << "{\"bufferView\":" << buffer.add(p, kVertices)
                  << ",\"componentType\":5126,\"type\":\"VEC3\",\"count\":" << part.points.size()
                  << ",\"min\":" << vec(low) << ",\"max\":" << vec(high)
                  << "},{\"bufferView\":" << buffer.add(indices, kIndices)
                  << ",\"componentType\":5125,\"type\":\"SCALAR\",\"count\":" << indices.size()
                  << "},{\"bufferView\":" << buffer.add(marks, 0)
                  << ",\"componentType\":5121,\"type\":\"SCALAR\",\"count\":" << marks.size()
                  << "}";
        meshes << comma << "{\"primitives\":[{\"attributes\":{\"POSITION\":" << accessor
               << "},\"indices\":" << accessor + 1
               << ",\"extensions\":{\"EXT_mesh_primitive_edge_visibility\":{\"visibility\":"
               << accessor + 2 << "}}}]}";
        nodes << comma << "{\"mesh\":" << n << ",\"name\":\"solid " << n << "\"}";
        list << comma << n;
        accessor += 3;
    }
    const std::string bytes = buffer.bytes();
    std::ostringstream json;
    json << R"({"asset":{"version":"2.0","generator":"inkbench experiments/brep/tessellate"},)"
         << R"("extensionsUsed":["EXT_mesh_primitive_edge_visibility"],"scene":0,)"
         << "\"scenes\":[{\"nodes\":[" << list.str() << "]}],\"nodes\":[" << nodes.str()
         << "],\"meshes\":[" << meshes.str() << "],\"accessors\":[" << accessors.str()
         << "],\"bufferViews\":[" << buffer.views()
         << "],\"buffers\":[{\"byteLength\":" << bytes.size() << "}]}";
    std::string text = json.str();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string glb;
    const auto number = [&](std::size_t value) {
        const auto word = static_cast<std::uint32_t>(value);
        glb.append(reinterpret_cast<const char*>(&word), sizeof(word));
    };
    glb += "glTF";
    number(2), number(28 + text.size() + bytes.size());
    number(text.size()), glb += "JSON" + text;
    number(bytes.size()), glb += std::string("BIN\0", 4) + bytes;
    return glb;
}

}  // namespace brep
