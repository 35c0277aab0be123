#include "gpu/Fence.h"

#include <utility>

#include "gpu/Gl.h"
#include "gpu/Loss.h"

namespace velum::gpu {

namespace {
GLsync syncOf(void* sync) { return static_cast<GLsync>(sync); }
}  // namespace

Fence::Fence(std::string_view label)
    : mSync(gl().FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)), mContext(contextNumber()) {
  gl().ObjectPtrLabel(mSync, GLsizei(label.size()), label.data());
}

Fence::Fence(Fence&& other) noexcept : mSync(std::exchange(other.mSync, nullptr)), mContext(other.mContext) {}

Fence& Fence::operator=(Fence&& other) noexcept {
  std::swap(mSync, other.mSync);
  std::swap(mContext, other.mContext);
  return *this;
}

Fence::~Fence() {
  if (mSync && mContext == contextNumber()) gl().DeleteSync(syncOf(mSync));
}

bool Fence::wait(double timeoutMs) const {
  if (!mSync) return true;
  GLenum state = gl().ClientWaitSync(syncOf(mSync), GL_SYNC_FLUSH_COMMANDS_BIT, GLuint64(timeoutMs * 1e6));
  return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

}  // namespace velum::gpu
