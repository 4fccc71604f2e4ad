#include "import/meshes/obj_parts.h"

#include <utility>

#include "import/meshes/polygons.h"

namespace ink::import {
namespace {

/// Gives a vertex what it has of a kind that others may lack.
template <class T>
void put(std::uint32_t vertex,
         std::uint32_t index,
         const std::vector<T>& from,
         std::vector<T>& to) {
    if (index == kNone) return;
    to.resize(vertex, T(0));
    to.push_back(from[index]);
}

/// Gives the different corners of one object their numbers.
class Vertices {
  public:
    explicit Vertices(const ObjContent& content)
        : content_(&content), first_(content.positions.size(), kNone) {}

    /// Begins with another object.
    void start(ImportedMesh& mesh) {
        for (const Entry& entry : entries_)
            first_[entry.corner.position] = kNone;
        entries_.clear();
        mesh_ = &mesh;
    }

    std::uint32_t number_of(const ObjCorner& corner) {
        std::uint32_t* link = &first_[corner.position];
        for (; *link != kNone; link = &entries_[*link].next)
            if (entries_[*link].corner == corner) return *link;
        const auto number = static_cast<std::uint32_t>(entries_.size());
        *link = number;
        entries_.push_back({corner, kNone});
        mesh_->positions.push_back(content_->positions[corner.position]);
        put(number, corner.normal, content_->normals, mesh_->normals);
        put(number, corner.texcoord, content_->texcoords, mesh_->texcoords);
        return number;
    }

    /// Of a kind all are there or none are.
    void finish() {
        const std::size_t count = mesh_->positions.size();
        if (!mesh_->normals.empty()) mesh_->normals.resize(count, glm::vec3(0));
        if (!mesh_->texcoords.empty()) mesh_->texcoords.resize(count, glm::vec2(0));
    }

  private:
    struct Entry {
        ObjCorner corner;
        std::uint32_t next;  ///< of the same position
    };
    const ObjContent* content_;
    std::vector<std::uint32_t> first_;  ///< per position of the file: its first entry
    std::vector<Entry> entries_;
    ImportedMesh* mesh_ = nullptr;
};

std::size_t end_of(const ObjContent& content, std::size_t run) {
    return run + 1 < content.runs.size() ? content.runs[run + 1].first_face : content.ends.size();
}

/// The faces of a run, by the mesh's own vertices.
Polygons faces_of(const ObjContent& content, std::size_t run, Vertices& vertices) {
    Polygons faces;
    for (std::size_t f = content.runs[run].first_face; f < end_of(content, run); ++f) {
        for (std::size_t c = f == 0 ? 0 : content.ends[f - 1]; c < content.ends[f]; ++c)
            faces.corners.push_back(vertices.number_of(content.corners[c]));
        faces.ends.push_back(faces.corners.size());
    }
    return faces;
}

void append_run(const ObjContent& content,
                std::size_t run,
                Vertices& vertices,
                ImportedMesh& mesh) {
    const Polygons faces = faces_of(content, run, vertices);
    const auto triangles = triangles_of(faces, mesh.positions);
    if (triangles.empty()) return;
    const std::uint32_t material = content.runs[run].material;
    if (mesh.parts.empty() || mesh.parts.back().material != material) {
        mesh.parts.push_back({.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size()),
                              .material = material});
    }
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
}

}  // namespace

std::vector<ImportedMesh> meshes_of(const ObjContent& content) {
    std::vector<std::vector<std::size_t>> runs_of_object(content.objects.size());
    for (std::size_t run = 0; run < content.runs.size(); ++run)
        runs_of_object[content.runs[run].object].push_back(run);
    Vertices vertices(content);
    std::vector<ImportedMesh> meshes;
    for (std::size_t object = 0; object < runs_of_object.size(); ++object) {
        ImportedMesh mesh;
        mesh.name = content.objects[object];
        vertices.start(mesh);
        for (const std::size_t run : runs_of_object[object])
            append_run(content, run, vertices, mesh);
        vertices.finish();
        if (!mesh.triangles.empty()) meshes.push_back(std::move(mesh));
    }
    return meshes;
}

}  // namespace ink::import
