// The ink of polygon_offset and back_faces against the same OpenGL calls on a software OpenGL, at
// equal cameras. Built where OSMesa is found (Debian: libosmesa6-dev).

#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <string>

#include "catalogue/catalogue.h"
#include "scene/surface.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

constexpr int kWidth_px = 640;
constexpr int kHeight_px = 480;

/// A scene's first camera at the test's size.
struct Stage {
    scene::Scene scene;
    scene::Surface surface;
    scene::View view;

    explicit Stage(const std::string& name) : scene(catalogue::make_catalogue_scene(name)) {
        surface = scene::flatten(scene);
        view.camera = scene.cameras.front();
        view.width_px = kWidth_px;
        view.height_px = kHeight_px;
    }
};

/// White, with a view's camera, drawn into memory row by row from the top.
class Canvas {
  public:
    explicit Canvas(const scene::View& view)
        : context_(OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr)),
          rgba_(static_cast<std::size_t>(view.width_px * view.height_px)) {
        if (context_ == nullptr) return;
        OSMesaMakeCurrent(context_, rgba_.data(), GL_UNSIGNED_BYTE, view.width_px, view.height_px);
        OSMesaPixelStore(OSMESA_Y_UP, 0);
        glViewport(0, 0, view.width_px, view.height_px);
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const scene::Camera& camera = view.camera;
        const double top = camera.near * std::tan(camera.fov_y_rad / 2);
        const double right = top * view.width_px / view.height_px;
        glMatrixMode(GL_PROJECTION);
        glFrustum(-right, right, -top, top, camera.near, camera.far);
        glMatrixMode(GL_MODELVIEW);
        const glm::dmat4 turn(camera.view_from_world);
        glLoadMatrixd(&turn[0][0]);
        glEnable(GL_DEPTH_TEST);  // GL_LESS
    }
    ~Canvas() {
        if (context_ != nullptr) OSMesaDestroyContext(context_);
    }
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    [[nodiscard]] bool is_ready() const { return context_ != nullptr; }
    [[nodiscard]] static std::string renderer() {
        return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    }
    void draw(const Stage& stage, GLenum mode, bool is_black) {
        const GLdouble shade = is_black ? 0 : 1;
        glColor3d(shade, shade, shade);
        glPolygonMode(GL_FRONT_AND_BACK, mode);
        glBegin(GL_TRIANGLES);
        for (const scene::Triangle& triangle : stage.surface.triangles) {
            for (const std::uint32_t corner : triangle) {
                const glm::dvec3 p = stage.surface.p_world[corner] - stage.view.camera.eye_world;
                glVertex3d(p.x, p.y, p.z);
            }
        }
        glEnd();
    }
    [[nodiscard]] edge::EdgeImage ink() const {
        glFinish();
        edge::EdgeImage image(kWidth_px, kHeight_px);
        for (std::size_t i = 0; i < rgba_.size(); ++i)
            image.data()[i] = (rgba_[i] & 0xffU) < 128 ? 255 : 0;
        return image;
    }

  private:
    OSMesaContext context_;
    std::vector<std::uint32_t> rgba_;
};

/// As the "Inked" page has it.
void draw_polygon_offset(Canvas& canvas, const Stage& stage, int width_px) {
    glLineWidth(static_cast<GLfloat>(width_px));
    canvas.draw(stage, GL_LINE, true);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-static_cast<GLfloat>(width_px) / 2, -1);
    canvas.draw(stage, GL_FILL, false);
}

/// As CoRgi has it after Lander.
void draw_back_faces(Canvas& canvas, const Stage& stage, int width_px) {
    glEnable(GL_CULL_FACE);
    glLineWidth(static_cast<GLfloat>(width_px));
    glCullFace(GL_FRONT);
    canvas.draw(stage, GL_LINE, true);
    glCullFace(GL_BACK);
    canvas.draw(stage, GL_FILL, false);
}

bool has_ink_near(const edge::EdgeImage& image, int x, int y) {
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        if (image.contains(x + dx, y + dy) && image.at(x + dx, y + dy) != 0) return true;
    }
    return false;
}

/// The share of `ink` within 1 px of some ink of `other`.
double share_near(const edge::EdgeImage& ink, const edge::EdgeImage& other) {
    int all = 0;
    int near = 0;
    for (int y = 0; y < ink.height_px(); ++y) {
        for (int x = 0; x < ink.width_px(); ++x) {
            if (ink.at(x, y) == 0) continue;
            ++all;
            near += has_ink_near(other, x, y) ? 1 : 0;
        }
    }
    EXPECT_GT(all, 300);
    return all == 0 ? 0 : static_cast<double>(near) / all;
}

using DrawInGl = void (*)(Canvas&, const Stage&, int);

void expect_same_ink(const std::string& method, DrawInGl draw_in_gl) {
    for (const std::string name : {"tree", "figure", "rocket", "cube"}) {
        const Stage stage(name);
        for (const int width_px : {1, 2, 3, 4, 5}) {
            Canvas canvas(stage.view);
            ASSERT_TRUE(canvas.is_ready());
            if (canvas.renderer().find("llvmpipe") == std::string::npos)
                GTEST_SKIP() << "written for llvmpipe, not for " << canvas.renderer();
            draw_in_gl(canvas, stage, width_px);
            const auto theirs = canvas.ink();
            const auto ours =
                drawn(method,
                      {{"width_px", std::to_string(width_px)}, {"depth_format", "z24"}},
                      stage.scene,
                      {stage.view, 1});
            SCOPED_TRACE(name + ", width " + std::to_string(width_px));
            EXPECT_GE(share_near(ours, theirs), 0.99);
            EXPECT_GE(share_near(theirs, ours), 0.99);
        }
    }
}

TEST(OsMesa, DrawsTheInkOfPolygonOffset) {
    expect_same_ink("polygon_offset", draw_polygon_offset);
}

TEST(OsMesa, DrawsTheInkOfBackFaces) {
    expect_same_ink("back_faces", draw_back_faces);
}

}  // namespace
}  // namespace ink::methods
