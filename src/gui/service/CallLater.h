#pragma once
#include <QObject>
#include <utility>

namespace velum::gui {

namespace detail {

/// A function object without its type, and how to call and delete it: see CallLater.cpp.
struct LaterCall {
  void* body;
  void (*run)(void* body);
  void (*drop)(void* body);
};
void callLater(QObject* owner, const LaterCall& call);

}  // namespace detail

/// Calls body() in the thread of `owner` when that thread comes back to its events; never, if the owner is deleted
/// before. Calls are made in the order in which they were asked for. This is the way from a worker into the window; may
/// be called from any thread.
template <class Body>
void callLater(QObject* owner, Body body) {
  detail::callLater(owner, {new Body(std::move(body)), [](void* of) { (*static_cast<Body*>(of))(); },
                            [](void* of) { delete static_cast<Body*>(of); }});
}

}  // namespace velum::gui
