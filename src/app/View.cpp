#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/Inputs.h"
#include "app/Verbs.h"
#include "gpu/Loss.h"
#include "gpu/SoftwareDriver.h"
#include "render/Renderer.h"
#include "scene/Navigate.h"
#include "scene/VisibleFrame.h"
#include "session/picture/Picture.h"

namespace velum::app {

namespace {

constexpr double kPatience = 0.2;  // seconds until a signal is heard that comes while nothing moves

struct ViewOptions {
  Common common;
  InputOptions input;
  std::string size = "1280x800";
};

/// The window's state, reached from GLFW's callbacks.
struct Viewer {
  scene::Scene scene;
  glm::dvec2 last{0.0};
  bool moved = true;
};

Viewer& viewerOf(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }

void onCursor(GLFWwindow* window, double x, double y) {
  Viewer& viewer = viewerOf(window);
  int width = 1, height = 1;
  glfwGetWindowSize(window, &width, &height);
  glm::dvec2 delta = (glm::dvec2(x, y) - viewer.last) / double(height);
  viewer.last = {x, y};
  bool left = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
  bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
  bool middle = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_MIDDLE) == GLFW_PRESS;
  bool right = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
  auto& camera = viewer.scene.camera;
  if (middle || (left && shift))
    camera = scene::pan(camera, delta);
  else if (left)
    camera = scene::orbit(camera, delta);
  else if (right)
    camera = scene::zoom(camera, std::exp(2.0 * delta.y));
  else
    return;
  viewer.moved = true;
}

void onScroll(GLFWwindow* window, double, double y) {
  Viewer& viewer = viewerOf(window);
  viewer.scene.camera = scene::zoom(viewer.scene.camera, std::pow(0.9, y));
  viewer.moved = true;
}

void onKey(GLFWwindow* window, int key, int, int action, int) {
  if (action != GLFW_PRESS) return;
  Viewer& viewer = viewerOf(window);
  auto view = [&](scene::StandardView side) { viewer.scene.camera = scene::frameVisible(viewer.scene, side, 1.6); };
  switch (key) {
    case GLFW_KEY_ESCAPE:
    case GLFW_KEY_Q:
      glfwSetWindowShouldClose(window, GLFW_TRUE);
      break;
    case GLFW_KEY_1:
      view(scene::StandardView::Anterior);
      break;
    case GLFW_KEY_2:
      view(scene::StandardView::Posterior);
      break;
    case GLFW_KEY_3:
      view(scene::StandardView::Left);
      break;
    case GLFW_KEY_4:
      view(scene::StandardView::Right);
      break;
    case GLFW_KEY_5:
      view(scene::StandardView::Superior);
      break;
    case GLFW_KEY_6:
      view(scene::StandardView::Inferior);
      break;
    case GLFW_KEY_M: {
      auto& mode = viewer.scene.rayCast.mode;
      mode = mode == scene::RenderMode::Volume ? scene::RenderMode::Mip : scene::RenderMode::Volume;
      break;
    }
    case GLFW_KEY_P: {
      auto& projection = viewer.scene.camera.projection;
      projection = projection == scene::Projection::Perspective ? scene::Projection::Orthographic
                                                                : scene::Projection::Perspective;
      break;
    }
    default:
      return;
  }
  viewer.moved = true;
}

struct Glfw {
  Glfw() {
    if (!glfwInit()) throw gpu::GpuError("view: there is no display; use velum-batch render");
  }
  ~Glfw() { glfwTerminate(); }
};

/// A window with a context that tells of resets, where the display has such. @throw gpu::TooOld where it has none at
/// all
struct Window {
  GLFWwindow* handle = nullptr;
  Window(glm::ivec2 size, const std::string& title) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    for (int robustness : {GLFW_LOSE_CONTEXT_ON_RESET, GLFW_NO_ROBUSTNESS}) {
      glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, robustness);
      if (!handle) handle = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    }
    // Of a driver that is too old, which then says what it offers.
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 1);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_ANY_PROFILE);
    if (!handle) handle = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!handle) throw gpu::TooOld("the graphics driver makes no OpenGL context");
    glfwMakeContextCurrent(handle);
  }
  ~Window() { glfwDestroyWindow(handle); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
};

std::unique_ptr<gpu::Context> adoptCurrent() {
  return gpu::Context::adopt([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); },
                             [] { return static_cast<const void*>(glfwGetCurrentContext()); });
}

/// Before anything is read. @throw gpu::TooOld, gpu::GpuError
void requireOpenGl() {
  Glfw glfw;
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  Window window({64, 64}, "Velum");
  adoptCurrent();
}

/// Frame after frame, until the window is closed; nothing is done while nothing changes. @throw gpu::ContextLost,
/// Cancelled
/// @param losses  of contexts since a picture was complete
void show(Viewer& viewer, GLFWwindow* window, int& losses) {
  auto context = adoptCurrent();
  render::Renderer renderer(*context);
  glfwSetWindowUserPointer(window, &viewer);
  glfwSetCursorPosCallback(window, onCursor);
  glfwSetScrollCallback(window, onScroll);
  glfwSetKeyCallback(window, onKey);
  bool done = false;
  while (!glfwWindowShouldClose(window)) {
    if (done && !viewer.moved)
      glfwWaitEventsTimeout(kPatience);
    else
      glfwPollEvents();
    consoleProgress().throwIfCancelled();
    render::Frame frame;
    frame.scene = viewer.scene;
    glfwGetFramebufferSize(window, &frame.pictureSize.x, &frame.pictureSize.y);
    glm::ivec2 windowSize = frame.pictureSize;
    if (viewer.moved) {
      // A quarter of the size while something moves; the full picture once it rests.
      viewer.moved = false;
      done = false;
      frame.pictureSize /= 4;
      frame.stepFactor = 2.0;
      frame.isPreview = true;
      frame.scene.rayCast.samplesPerPixel = 1;
      renderer.render(frame, consoleProgress());
      renderer.present(0, windowSize);
    } else {
      done = renderer.work(frame, 30.0);
      if (done) losses = 0;
      if (renderer.stats().samples < 1) continue;
      renderer.present(0, windowSize);
    }
    glfwSwapBuffers(window);
  }
}

int run(const ViewOptions& options) {
  glm::ivec2 size = session::parsePictureSize(options.size, 0);
  requireOpenGl();
  if (std::string reason = gpu::softwareReason(); !reason.empty()) gpu::warnOfSoftware(reason);
  Viewer viewer;
  {
    session::Session
        session;  // the session's own context, if it needs one, is gone before the window's context is made
    session.setContextKind(options.common.context);
    openInputs(session, options.input, double(size.x) / size.y);
    viewer.scene = session.settled(consoleProgress());
  }
  consoleProgress().report(1.0, "");
  Glfw glfw;
  const auto& named = options.input.inputs.empty() ? options.input.labels : options.input.inputs.front();
  for (int losses = 0;; ++losses) {
    Window window(size, fmt::format("Velum - {}", named));
    try {
      show(viewer, window.handle, losses);
      return 0;
    } catch (const gpu::ContextLost&) {
      if (losses == gpu::kMostLosses) gpu::giveUpAfterLosses();
      viewer.moved = true;  // another window with another context
    }
  }
}

}  // namespace

Run registerView(CLI::App& verb) {
  auto options = std::make_shared<ViewOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("--size", options->size, "WIDTHxHEIGHT of the window")->capture_default_str();
  return [options] { return run(*options); };
}

}  // namespace velum::app
