#include "render/gl/gl_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <array>
#include <initializer_list>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace talus {
namespace {

/// A shared library that is looked for when it is needed, not when the program starts.
class SharedLibrary {
 public:
  SharedLibrary(std::initializer_list<const char*> names, int flags) {
    for (const char* name : names)
      if ((handle_ = dlopen(name, flags))) return;
  }
  template <class Function>
  bool find(Function& function, const char* name) const {
    function = handle_ ? reinterpret_cast<Function>(dlsym(handle_, name)) : nullptr;
    return function != nullptr;
  }

 private:
  void* handle_ = nullptr;
};

// The part of GLVND's GLdispatch.h that is needed here. It is internal (not installed), hence the check of its version.
struct DispatchThreadState {
  int tag;
  void (*thread_destroyed)(DispatchThreadState*);
  void* private_data;
};
using FindProcedure = void* (*)(const char* name, void* parameter);

/// OSMesa's library, registered with libGLdispatch as one more GL vendor, just as libGLX and libEGL register theirs.
/// VTK and GLEW hold GLVND's dispatch stubs, so their calls then go to OSMesa on the threads where it is current.
class OsMesaVendor {
 public:
  static const OsMesaVendor* get() {
    static const OsMesaVendor vendor;
    return vendor.usable_ ? &vendor : nullptr;
  }

  decltype(&OSMesaCreateContextAttribs) create;
  decltype(&OSMesaDestroyContext) destroy;
  decltype(&OSMesaMakeCurrent) make_current;
  DispatchThreadState* (*current_state)();
  void (*lose_current)();

  bool dispatch_to(DispatchThreadState& state) const {
    return dispatch_make_current_(&state, table_, vendor_, nullptr);
  }

 private:
  static constexpr int known_dispatch_version = 1;

  OsMesaVendor() {
    // RTLD_LOCAL: OSMesa's gl* symbols stay its own.
    const SharedLibrary mesa({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}, RTLD_NOW | RTLD_LOCAL);
    const SharedLibrary dispatch({"libGLdispatch.so.0"}, RTLD_NOW | RTLD_GLOBAL);
    int (*version)() = nullptr;
    void (*init)() = nullptr;
    int (*new_vendor)() = nullptr;
    void* (*create_table)(FindProcedure, void*) = nullptr;
    const bool found = mesa.find(create, "OSMesaCreateContextAttribs") && mesa.find(destroy, "OSMesaDestroyContext") &&
                       mesa.find(make_current, "OSMesaMakeCurrent") && mesa.find(procedure(), "OSMesaGetProcAddress") &&
                       dispatch.find(version, "__glDispatchGetABIVersion") && dispatch.find(init, "__glDispatchInit") &&
                       dispatch.find(new_vendor, "__glDispatchNewVendorID") &&
                       dispatch.find(create_table, "__glDispatchCreateTable") &&
                       dispatch.find(dispatch_make_current_, "__glDispatchMakeCurrent") &&
                       dispatch.find(lose_current, "__glDispatchLoseCurrent") &&
                       dispatch.find(current_state, "__glDispatchGetCurrentThreadState");
    if (!found || version() != known_dispatch_version) return;
    init();
    vendor_ = new_vendor();
    table_ = create_table([](const char* name, void*) { return reinterpret_cast<void*>(procedure()(name)); }, nullptr);
    usable_ = table_ != nullptr;
  }

  static decltype(&OSMesaGetProcAddress)& procedure() {
    static decltype(&OSMesaGetProcAddress) function = nullptr;
    return function;
  }

  unsigned char (*dispatch_make_current_)(DispatchThreadState*, void* table, int vendor, const void* patch);
  void* table_ = nullptr;
  int vendor_ = 0;
  bool usable_ = false;
};

class OsMesaContext final : public GlContext {
 public:
  explicit OsMesaContext(const OsMesaVendor& vendor) : vendor_(vendor) {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_STENCIL_BITS,
                              8,
                              OSMESA_ACCUM_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = vendor_.create(attributes, nullptr);
    state_.tag = 0x6f73;  // any number that is neither GLX's nor EGL's
    state_.thread_destroyed = [](DispatchThreadState*) {};
  }
  ~OsMesaContext() override {
    done_current();
    if (context_) vendor_.destroy(context_);
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  bool make_current() override {
    if (is_current()) return true;
    if (const DispatchThreadState* other = vendor_.current_state()) {
      if (other->tag != state_.tag) return false;  // only its owner may release a GLX or EGL context
      vendor_.lose_current();
    }
    constexpr int side = buffer_side;
    if (!context_ || !vendor_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, side, side)) return false;
    return vendor_.dispatch_to(state_);
  }
  void done_current() override {
    if (!is_current()) return;
    vendor_.lose_current();
    vendor_.make_current(nullptr, nullptr, 0, 0, 0);
  }
  bool is_current() const override { return vendor_.current_state() == &state_; }
  std::string name() const override { return "OSMesa"; }

 private:
  static constexpr int buffer_side = 16;  // VTK draws into frame buffers of its own, of any size

  const OsMesaVendor& vendor_;
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, buffer_side * buffer_side * 4> buffer_{};
  DispatchThreadState state_{};
};

class EglContext final : public GlContext {
 public:
  EglContext() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform_display) display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    eglChooseConfig(display_, wanted, &config, 1, &count);
    const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, count > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  }
  ~EglContext() override {
    if (context_ == EGL_NO_CONTEXT) return;
    if (is_current()) done_current();
    eglDestroyContext(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  bool make_current() override {
    if (context_ == EGL_NO_CONTEXT) return false;
    eglBindAPI(EGL_OPENGL_API);
    return is_current() || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }
  void done_current() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  bool is_current() const override { return context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_; }
  std::string name() const override { return "EGL surfaceless"; }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// Contexts of windows that are gone, for the next ones: what a context has compiled for its shaders goes with it, and
/// Mesa keeps but a part of that on the disk, a tenth of a second for a scene. Never destroyed: the libraries that they
/// need may be gone first.
class KeptContexts {
 public:
  static KeptContexts& get() {
    static auto* const kept = new KeptContexts;
    return *kept;
  }

  std::unique_ptr<GlContext> take() {
    const std::lock_guard lock(guard_);
    if (contexts_.empty()) return nullptr;
    std::unique_ptr<GlContext> context = std::move(contexts_.back());
    contexts_.pop_back();
    return context;
  }
  void keep(std::unique_ptr<GlContext> context) {
    const std::lock_guard lock(guard_);
    if (contexts_.size() < most) contexts_.push_back(std::move(context));
  }

 private:
  static constexpr std::size_t most = 4;
  std::mutex guard_;
  std::vector<std::unique_ptr<GlContext>> contexts_;
};

/// One of OSMesa's contexts that is kept when it is no longer needed.
class LentContext final : public GlContext {
 public:
  explicit LentContext(std::unique_ptr<GlContext> context) : context_(std::move(context)) {}
  ~LentContext() override {
    context_->done_current();
    KeptContexts::get().keep(std::move(context_));
  }
  LentContext(const LentContext&) = delete;
  LentContext& operator=(const LentContext&) = delete;

  bool make_current() override { return context_->make_current(); }
  void done_current() override { context_->done_current(); }
  bool is_current() const override { return context_->is_current(); }
  std::string name() const override { return context_->name(); }

 private:
  std::unique_ptr<GlContext> context_;
};

/// The context if it can be made current on this thread, else nothing.
std::unique_ptr<GlContext> if_usable(std::unique_ptr<GlContext> context) {
  if (!context->make_current()) return nullptr;
  context->done_current();
  return context;
}

}  // namespace

std::unique_ptr<GlContext> make_offscreen_context(OffscreenBackend backend) {
  if (backend != OffscreenBackend::egl)
    if (const OsMesaVendor* vendor = OsMesaVendor::get()) {
      auto context = KeptContexts::get().take();
      if (!context) context = std::make_unique<OsMesaContext>(*vendor);
      context = if_usable(std::move(context));  // one that is not must not be kept
      if (context) return std::make_unique<LentContext>(std::move(context));
    }
  if (backend != OffscreenBackend::osmesa)
    if (auto context = if_usable(std::make_unique<EglContext>())) return context;
  throw std::runtime_error(
      "no off-screen OpenGL: install libosmesa6 (or libegl-mesa0), and draw on a thread without another GL context");
}

}  // namespace talus
