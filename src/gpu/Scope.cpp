#include "gpu/Scope.h"

#include "gpu/Gl.h"

namespace velum::gpu {

namespace {
unsigned timestamp() {
  unsigned id = 0;
  gl().CreateQueries(GL_TIMESTAMP, 1, &id);
  gl().QueryCounter(id, GL_TIMESTAMP);
  return id;
}
}  // namespace

PassTimes::~PassTimes() {
  for (auto& [name, pair] : mQueries)
    if (hasGl()) {
      gl().DeleteQueries(1, &pair.first);
      gl().DeleteQueries(1, &pair.second);
    }
}

std::map<std::string, double> PassTimes::collectMs() {
  std::map<std::string, double> sums;
  for (auto& [name, pair] : mQueries) {
    GLuint64 begin = 0, end = 0;
    gl().GetQueryObjectui64v(pair.first, GL_QUERY_RESULT, &begin);
    gl().GetQueryObjectui64v(pair.second, GL_QUERY_RESULT, &end);
    sums[name] += double(end - begin) * 1e-6;
    gl().DeleteQueries(1, &pair.first);
    gl().DeleteQueries(1, &pair.second);
  }
  mQueries.clear();
  return sums;
}

Scope::Scope(PassTimes* times, std::string_view name) : mTimes(times), mName(name) {
  gl().PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, GLsizei(name.size()), name.data());
  if (mTimes) mBegin = timestamp();
}

Scope::~Scope() {
  if (mTimes) mTimes->mQueries.emplace(mName, std::pair(mBegin, timestamp()));
  gl().PopDebugGroup();
}

}  // namespace velum::gpu
