#include "ui/view/offscreen_renderer.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

namespace handlebody::ui {
namespace {

QSurfaceFormat coreProfile() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setRenderableType(QSurfaceFormat::OpenGL);
  return format;
}

void observe(vtkObject* object, unsigned long event, vtkCallbackCommand* command, void* data,
             void (*call)(vtkObject*, unsigned long, void*, void*)) {
  command->SetClientData(data);
  command->SetCallback(call);
  object->AddObserver(event, command);
}

}  // namespace

struct OffscreenRenderer::Private {
  bool create();
  void connectWindow();
  QImage readPixels(const QSize& size);

  QOpenGLContext context;
  QOffscreenSurface surface;
  bool valid = false;
  std::function<void()> request;
  // Not created without OpenGL.
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window;
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkGenericRenderWindowInteractor> interactor;
};

bool OffscreenRenderer::Private::create() {
  context.setFormat(coreProfile());
  if (!context.create()) return false;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return false;
  return context.format().version() >= qMakePair(3, 2);
}

void OffscreenRenderer::Private::connectWindow() {
  vtkNew<vtkCallbackCommand> makeCurrent, isCurrent, supports, isDirect, renderRequest;
  observe(window, vtkCommand::WindowMakeCurrentEvent, makeCurrent, this,
          [](vtkObject*, unsigned long, void* d, void*) {
            auto* self = static_cast<Private*>(d);
            self->context.makeCurrent(&self->surface);
          });
  observe(window, vtkCommand::WindowIsCurrentEvent, isCurrent, this,
          [](vtkObject*, unsigned long, void* d, void* out) {
            *static_cast<bool*>(out) = QOpenGLContext::currentContext() == &static_cast<Private*>(d)->context;
          });
  observe(window, vtkCommand::WindowSupportsOpenGLEvent, supports, this,
          [](vtkObject*, unsigned long, void*, void* out) { *static_cast<int*>(out) = 1; });
  observe(window, vtkCommand::WindowIsDirectEvent, isDirect, this,
          [](vtkObject*, unsigned long, void*, void* out) { *static_cast<int*>(out) = 1; });
  observe(interactor, vtkCommand::RenderEvent, renderRequest, this,
          [](vtkObject*, unsigned long, void* d, void*) {
            auto* self = static_cast<Private*>(d);
            if (self->request) self->request();
          });
}

OffscreenRenderer::OffscreenRenderer() : d_(std::make_unique<Private>()) {
  d_->valid = d_->create();
  if (!d_->valid) return;
  d_->window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  d_->renderer = vtkSmartPointer<vtkRenderer>::New();
  d_->interactor = vtkSmartPointer<vtkGenericRenderWindowInteractor>::New();
  d_->window->SetOwnContext(0);
  d_->window->SetFrameBlitModeToNoBlit();
  d_->window->SetMultiSamples(0);  // four samples cost four times as long in software
  d_->window->AddRenderer(d_->renderer);
  d_->interactor->SetRenderWindow(d_->window);
  d_->interactor->EnableRenderOff();
  d_->connectWindow();
  d_->window->SetReadyForRendering(true);
  d_->interactor->Initialize();
  d_->context.doneCurrent();
}

OffscreenRenderer::~OffscreenRenderer() {
  if (!d_->valid) return;
  d_->request = nullptr;
  // What VTK holds in OpenGL is freed while its context is there.
  d_->context.makeCurrent(&d_->surface);
  d_->window->Finalize();
  d_->interactor->SetRenderWindow(nullptr);
  d_->renderer = nullptr;
  d_->interactor = nullptr;
  d_->window = nullptr;
  d_->context.doneCurrent();
}

bool OffscreenRenderer::isValid() const { return d_->valid; }
vtkRenderer* OffscreenRenderer::renderer() const { return d_->renderer; }
vtkGenericRenderWindowInteractor* OffscreenRenderer::interactor() const { return d_->interactor; }
void OffscreenRenderer::onRenderRequest(std::function<void()> request) { d_->request = std::move(request); }

QImage OffscreenRenderer::Private::readPixels(const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  window->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  QOpenGLFunctions* gl = context.functions();
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_BYTE, image.bits());
  window->GetDisplayFramebuffer()->UnBind(GL_READ_FRAMEBUFFER);
  return image.mirrored();  // OpenGL's rows run up
}

QImage OffscreenRenderer::render(const QSize& wanted, double pixelRatio) {
  const QSize size = wanted.expandedTo({1, 1});
  d_->context.makeCurrent(&d_->surface);
  if (d_->window->GetSize()[0] != size.width() || d_->window->GetSize()[1] != size.height()) {
    d_->window->SetSize(size.width(), size.height());
    d_->interactor->SetSize(size.width(), size.height());
  }
  d_->window->SetDPI(static_cast<int>(72 * pixelRatio));
  d_->window->SetReadyForRendering(true);
  vtkOpenGLState* state = d_->window->GetState();
  state->Reset();
  state->Push();
  d_->window->Render();
  QImage image = d_->readPixels(size);
  state->Reset();
  state->Pop();
  d_->context.doneCurrent();
  return image;
}

}  // namespace handlebody::ui
