// The vectors of id_lookup and surface_lookup against what they are defined as, on every target.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "catalogue/shapes.h"
#include "methods/mesh_lookup/screen_kernel.h"
#include "methods/mesh_lookup/side_lists.h"
#include "raster/pass/screen_vertex.h"
#include "scene/predicates.h"
#include "tests/edge/guarded.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

using edge::on_every_target;

/// Triangles of every kind: of any corners, slivers, far from the origin, and parallel to axes.
scene::Mesh any_triangles(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1, 1);
    scene::Mesh mesh;
    for (int i = 0; i < count; ++i) {
        glm::vec3 a(any(random), any(random), any(random));
        glm::vec3 b(any(random), any(random), any(random));
        glm::vec3 c(any(random), any(random), any(random));
        if (i % 4 == 1) c = a + (b - a) * any(random) + 1e-6F * c;
        if (i % 4 == 2) a.z = b.z = c.z = 0.25F;
        if (i % 4 == 3) {
            a *= 1000;
            b = a + 0.01F * b;
            c = a + 0.01F * c;
        }
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {a, b, c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

TEST(FindFacing, IsThatOfThePredicate) {
    const scene::Scene scene = scene_of({any_triangles(2003)});
    const LookupMesh mesh = make_lookup_mesh(scene, {.crease_rad = 1});
    ASSERT_GT(mesh.faces.size(), 1500U);
    // One of the eyes lies in the plane of a quarter of the faces, one on a vertex.
    const glm::dvec3 along_a_side = mesh.p_world[1] - mesh.p_world[0];
    for (const scene::Viewpoint& eye : {scene::Viewpoint{{0.3, 0.2, 2}},
                                        {{0.1, -0.7, 0.25}},
                                        {mesh.p_world[5]},
                                        {{1e6, 3, -1e7}},
                                        {{0.3, 0.2, 2}, true},
                                        {{0, 0, -1}, true},
                                        {along_a_side, true}}) {
        on_every_target([&] {
            std::vector<std::int8_t> facing(mesh.faces.size(), 7);
            find_facing(mesh, eye, 0, 100, facing);
            find_facing(mesh, eye, 100, facing.size(), facing);
            for (std::size_t f = 0; f < facing.size(); ++f) {
                const auto& [a, b, c] = mesh.faces[f].vertices;
                ASSERT_EQ(facing[f],
                          scene::facing(mesh.p_world[a], mesh.p_world[b], mesh.p_world[c], eye))
                    << f;
            }
        });
    }
}

TEST(ToScreen, IsThatOfTheRasterizer) {
    const scene::View view = view_from(scene_of({cube_mesh()}), {1, 2, 4}, {0, 0, 0}, {640, 400});
    const raster::ViewTransform transform(view);
    std::mt19937 random(3);
    std::normal_distribution<double> any(0, 1);
    for (std::size_t count = 0; count < 40; ++count) {
        // Most are in view; some lie behind the eye, far out, or nowhere.
        std::vector<glm::dvec3> p_world(count);
        for (glm::dvec3& p : p_world)
            p = glm::dvec3(any(random), any(random), any(random)) * (count % 3 == 0 ? 30.0 : 1.0);
        if (count > 20) p_world[count / 2] = {1e200, 0, 0};
        if (count > 30) p_world[count / 3] = {std::nan(""), 0, 0};
        on_every_target([&] {
            std::vector<double> q(count, -1);
            std::vector<glm::ivec2> places(count);
            to_screen(p_world, transform, view.camera.near, q, places);
            for (std::size_t i = 0; i < count; ++i) {
                const glm::dvec3 p_clip = transform.to_clip(p_world[i]);
                const bool is_inside = raster::outcode(p_clip, view.camera.near) == raster::kInside;
                ASSERT_EQ(places[i].x != kOffScreen, is_inside) << i;
                if (!is_inside) continue;
                const raster::ScreenVertex expected = raster::to_screen(p_clip);
                ASSERT_EQ(q[i], expected.q);
                ASSERT_EQ(places[i], glm::ivec2(expected.x, expected.y));
            }
        });
    }
}

TEST(WriteBits, WritesAByteABitAndNothingElse) {
    std::mt19937_64 random(1);
    on_every_target([&] {
        for (int width = 0; width <= 64; ++width) {
            const std::uint64_t bits = random();
            std::vector<std::uint8_t> out(80, 9);
            write_bits(bits, width, out.data());
            for (int x = 0; x < 80; ++x)
                ASSERT_EQ(out[x], x >= width ? 9 : (bits >> x & 1) != 0 ? 255 : 0) << x;
        }
    });
}

/// A tile of words and depths that are not those of any scene, with room round it.
struct AnyTile {
    static constexpr int kSpan = 96;
    std::vector<std::uint32_t> words = std::vector<std::uint32_t>(kSpan * kSpan);
    std::vector<float> q = std::vector<float>(kSpan * kSpan);
    raster::Tile tile;

    AnyTile(glm::ivec2 size_px, std::uint32_t faces, bool has_codes, unsigned seed) {
        std::mt19937 random(seed);
        for (std::size_t i = 0; i < words.size(); ++i) {
            // Runs of one face, so that some samples are alike.
            const auto dice = static_cast<std::uint32_t>(random());
            words[i] = i > 0 && dice % 3 == 0 ? words[i - 1]
                                              : static_cast<std::uint32_t>(random()) % faces;
            if (has_codes && words[i] != kNoNeighbour && words[i] < faces) {
                const std::uint32_t face = words[i];  // words of a face are alike
                words[i] |= (face * 3 % 11) << LookupWord::kCodeShift;
                if (face % 13 == 0) words[i] |= LookupWord::kFlag;
            }
            if (dice % 17 == 0) words[i] = kNoNeighbour;
            q[i] = 1.0F + static_cast<float>(random() % 5) * 1e-4F;
        }
        tile.width_px = size_px.x;
        tile.height_px = size_px.y;
        tile.halo_px = 2;
        tile.stride = kSpan;
        tile.planes[0] = words.data() + 8 * kSpan + 8;
        tile.depth = q.data() + 8 * kSpan + 8;
    }
};

/// Faces whose twins are any others.
LookupMesh any_mesh(std::uint32_t faces, std::vector<std::int8_t>& facing) {
    std::mt19937 random(11);
    LookupMesh mesh;
    mesh.faces.resize(faces);
    for (LookupFace& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            face.twins[i] = Twin::of(static_cast<std::uint32_t>(random()) % faces, random() % 3);
            if (random() % 4 == 0) face.twins[i].word |= Twin::kTurned;
            if (random() % 4 == 0) face.twins[i].word |= Twin::kClosed;
        }
        if (random() % 4 == 0) face.twins[random() % 3] = {};
        facing.push_back(static_cast<std::int8_t>(static_cast<int>(random() % 3) - 1));
    }
    return mesh;
}

/// What list_sides is defined as, one side after the other.
class PlainSides {
  public:
    std::multiset<std::uint32_t> places;
    std::set<std::pair<int, int>> pixels;

    PlainSides(const WordTile& words, const CodeRule* rule, bool lists_lines)
        : words_(words), rule_(rule), lists_lines_(lists_lines) {
        const int first = words.has_corners ? 0 : -1;
        for (int y = first; y <= words.tile.height_px; ++y) {
            for (int x = first; x <= words.tile.width_px; ++x) {
                if (x < words.tile.width_px) look(x, y, false);
                if (y < words.tile.height_px) look(x, y, true);
            }
        }
    }

  private:
    [[nodiscard]] static float least(const CodeRule::Bend& bend, float q) {
        return bend.of_q * q + bend.constant;
    }
    [[nodiscard]] std::uint32_t word(int x, int y) const {
        return words_.tile.row<std::uint32_t>(0, y)[x];
    }
    [[nodiscard]] float q(int x, int y) const { return words_.tile.depth_row<float>(y)[x]; }

    void look(int x, int y, bool is_down) {
        const int dx = is_down ? 0 : 1, dy = is_down ? 1 : 0;
        const std::uint32_t a = word(x, y), b = word(x + dx, y + dy);
        if (a == b) return;
        const auto place =
            static_cast<std::uint32_t>((y + 1) << 8 | (x + 1) << 1 | (is_down ? 1 : 0));
        const bool has_sky = a == kNoNeighbour || b == kNoNeighbour;
        if (rule_ != nullptr) {
            const float q0 = q(x - dx, y - dy), q1 = q(x, y), q2 = q(x + dx, y + dy),
                        q3 = q(x + 2 * dx, y + 2 * dy);
            const float bend_a = std::abs(q2 - q1 - (q1 - q0));
            const float bend_b = std::abs(q2 - q1 - (q3 - q2));
            const int apart = std::abs(static_cast<int>(a >> LookupWord::kCodeShift) -
                                       static_cast<int>(b >> LookupWord::kCodeShift));
            const bool is_flagged = ((a | b) & LookupWord::kFlag) != 0;
            const float nearest = std::max(q1, q2);
            const bool is_sure =
                has_sky || (apart >= rule_->trust && !is_flagged &&
                            std::max(bend_a, bend_b) > least(rule_->flat, nearest));
            if (is_sure && !lists_lines_ && (is_cut(a) || is_cut(b))) {
                places.insert(place);
                return;
            }
            if (is_sure && !lists_lines_) {
                pixels.insert({x, y});
                pixels.insert(is_down ? std::pair{x - 1, y} : std::pair{x, y - 1});
                return;
            }
            if (!is_sure && apart < 2 && !is_flagged &&
                !(std::min(bend_a, bend_b) > least(rule_->jump, nearest)))
                return;
        }
        if (!has_sky && is_open(a & words_.face_bits, b & words_.face_bits)) return;
        places.insert(place);
    }
    [[nodiscard]] bool is_cut(std::uint32_t word) const {
        return !words_.is_cut.empty() && word != kNoNeighbour &&
               words_.is_cut[word & words_.face_bits] != 0;
    }
    [[nodiscard]] bool is_open(std::uint32_t a, std::uint32_t b) const {
        for (const Twin twin : words_.faces[a].twins) {
            const int mine = words_.facing[a], theirs = words_.facing[b];
            if (!twin.is_nothing() && !twin.is_closed() && twin.face() == b &&
                mine * theirs * (twin.is_turned() ? -1 : 1) > 0)
                return true;
        }
        return false;
    }

    const WordTile& words_;
    const CodeRule* rule_;
    bool lists_lines_;
};

TEST(ListSides, AreThoseOfThePlainRule) {
    constexpr std::uint32_t kFaces = 60;
    std::vector<std::int8_t> facing;
    const LookupMesh mesh = any_mesh(kFaces, facing);
    const CodeRule rule{.jump = {.of_q = 1.5e-4F}, .flat = {.of_q = 0.5e-4F}, .trust = 4};
    std::vector<std::uint8_t> is_cut(kFaces);
    for (std::size_t f = 0; f < kFaces; ++f)
        is_cut[f] = f % 5 == 0;
    for (const glm::ivec2 size : {glm::ivec2{64, 64}, {1, 1}, {17, 5}, {63, 2}, {3, 64}}) {
        for (const bool has_codes : {false, true}) {
            const AnyTile any(size, kFaces, has_codes, static_cast<unsigned>(size.x));
            // Corners, corners of a scene that the near plane cuts, centres, and corners of which
            // lines are listed, too.
            for (const int kind : {0, 1, 2, 3}) {
                const bool has_corners = kind != 2;
                const CodeRule* const used = has_codes && has_corners ? &rule : nullptr;
                const WordTile words{
                    .tile = any.tile,
                    .has_corners = has_corners,
                    .face_bits = has_codes ? LookupWord::kFaceOfCoded : kNoNeighbour,
                    .faces = mesh.faces,
                    .facing = facing,
                    .is_cut = std::span(is_cut).first(kind == 1 ? kFaces : 0)};
                const PlainSides expected(words, used, kind == 3);
                on_every_target([&] {
                    LineBits lines;
                    lines.clear();
                    SideList list;
                    list_sides(words, used, kind == 3 ? nullptr : &lines, list);
                    EXPECT_EQ(std::multiset<std::uint32_t>(
                                  list.places.begin(),
                                  list.places.begin() + static_cast<std::ptrdiff_t>(list.count)),
                              expected.places);
                    for (int y = 0; y < size.y; ++y) {
                        for (int x = 0; x < size.x; ++x)
                            ASSERT_EQ(lines.is_set(x, y), expected.pixels.contains({x, y}))
                                << x << ' ' << y;
                    }
                });
            }
        }
    }
}

TEST(LookupMesh, TwinsPointBackAndVerticesComeByFirstUse) {
    const LookupMesh mesh = make_lookup_mesh(
        scene_of({catalogue::make_icosphere(1, 3), any_triangles(50)}), {.crease_rad = 1});
    std::uint32_t next_vertex = 0;
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_LE(mesh.faces[f].vertices[i], next_vertex);
            next_vertex = std::max(next_vertex, mesh.faces[f].vertices[i] + 1);
            const Twin twin = mesh.faces[f].twins[i];
            if (twin.is_nothing()) continue;
            const Twin back = mesh.faces[twin.face()].twins[twin.edge()];
            EXPECT_EQ(back.face(), f);
            EXPECT_EQ(back.edge(), i);
            EXPECT_EQ(back.is_turned(), twin.is_turned());
            EXPECT_EQ(back.is_closed(), twin.is_closed());
        }
    }
    EXPECT_EQ(next_vertex, mesh.p_world.size());
}

}  // namespace
}  // namespace ink::methods
