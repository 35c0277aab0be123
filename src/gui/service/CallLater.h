#pragma once
#include <QObject>
#include <utility>

namespace velum::gui {

namespace detail {

/// What is to be called, without its type: see CallLater.cpp.
struct LaterCall {
  void* body;
  void (*run)(void* body);
  void (*drop)(void* body);
};
void callLater(QObject* owner, const LaterCall& call);

}  // namespace detail

/// Calls body() in the thread of `owner` when that comes back to its events; never, if the owner goes before. In the
/// order in which it was asked for. The way from a worker into the window. Any thread.
template <class Body>
void callLater(QObject* owner, Body body) {
  detail::callLater(owner, {new Body(std::move(body)), [](void* of) { (*static_cast<Body*>(of))(); },
                            [](void* of) { delete static_cast<Body*>(of); }});
}

}  // namespace velum::gui
