// Floor 2. Which bodies are connected.
#pragma once

#include <algorithm>

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Sets of connected bodies, each known by its lowest body (union-find: B. A. Galler, M. J. Fischer, 1964).
class ConnectedBodies {
 public:
  /// So many bodies, each by itself.
  void begin(int bodies) {
    parent_.clear();
    for (int i = 0; i < bodies; ++i) parent_.push_back({i});
  }
  /// The lowest body of a body's set. Halves the path on the way.
  BodyId lowest(BodyId body) {
    while (parent_[body] != body) {
      parent_[body] = parent_[parent_[body]];
      body = parent_[body];
    }
    return body;
  }
  /// Makes one set of two.
  void connect(BodyId a, BodyId b) {
    a = lowest(a);
    b = lowest(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  PerBody<BodyId> parent_;  // towards the lowest: never a higher id
};

}  // namespace cairn
