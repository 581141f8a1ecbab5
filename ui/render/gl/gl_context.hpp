#pragma once

#include <memory>
#include <string>

namespace talus {

/// An OpenGL context that a RenderWindow draws with. Current on one thread at a time.
class GlContext {
 public:
  virtual ~GlContext() = default;
  virtual bool make_current() = 0;
  virtual void done_current() = 0;
  virtual bool is_current() const = 0;
  /// What draws: "OSMesa", "EGL surfaceless", "Qt".
  virtual std::string name() const = 0;
};

enum class OffscreenBackend {
  automatic,  ///< OSMesa, and EGL where OSMesa is not to be had
  osmesa,
  egl
};

/// A context that needs neither a display nor a GPU, not yet current. Throws std::runtime_error that names the missing
/// package. It cannot be made current on a thread on which a foreign context (Qt's) is: release that first.
std::unique_ptr<GlContext> make_offscreen_context(OffscreenBackend backend = OffscreenBackend::automatic);

}  // namespace talus
