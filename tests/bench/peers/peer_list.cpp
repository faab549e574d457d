// The settings under which engines are compared. A further one of Cairn is one line in one of the two lists.
#include "peer_list.hpp"

#include <fmt/format.h>

#include <utility>

#include <cairn/scenes/default_setting.hpp>
#include <cairn/study/build_info.hpp>

namespace cairn::bench {

namespace {

const Stabilization soft = {.policy = StabilizationPolicy::soft};

constexpr ContactSearch when_moved = ContactSearch::when_moved;

List<Setting> usual_settings_of_cairn() {
  return {{.solver = "si", .sweeps = {.iterations = 10}},
          {.solver = "block", .sweeps = {.iterations = 10}, .substeps = 4},
          {.solver = "accelerated", .sweeps = {.iterations = 20}},
          {.solver = "newton", .sweeps = {.iterations = 50, .tolerance = 1e-6}},
          {.solver = "newton", .sweeps = {.iterations = 50, .tolerance = 1e-6}, .contact_search = when_moved},
          {.solver = "si", .sweeps = {.iterations = 1}, .substeps = 4, .stabilization = soft},
          {.solver = "wide", .sweeps = {.iterations = 20}, .contact_search = when_moved},
          {.solver = "wide", .sweeps = {.iterations = 300, .tolerance = 1e-3}, .contact_search = when_moved},
          {.solver = "wide-accelerated",
           .sweeps = {.iterations = 300, .tolerance = 1e-3},
           .contact_search = when_moved},
          {.solver = "wide",
           .sweeps = {.iterations = 1},
           .substeps = 4,
           .contact_search = when_moved,
           .stabilization = soft}};
}

/// Of rising cost, for each method.
List<List<Setting>> settings_of_cairn() {
  List<List<Setting>> all(9);
  for (const int sweeps : {5, 10, 20, 40, 80, 160}) {
    all[0].push_back({.solver = "si", .sweeps = {.iterations = sweeps}});
    all[1].push_back({.solver = "accelerated", .sweeps = {.iterations = sweeps}});
  }
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    all[2].push_back({.solver = "newton", .sweeps = {.iterations = 50, .tolerance = tolerance}});
  }
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const SolverSettings sweeps = {.iterations = 300, .tolerance = tolerance};
    all[7].push_back({.solver = "wide", .sweeps = sweeps, .contact_search = when_moved});
    all[8].push_back({.solver = "wide-accelerated", .sweeps = sweeps, .contact_search = when_moved});
  }
  for (const int substeps : {2, 4, 8, 16}) {
    all[3].push_back(
        {.solver = "si", .sweeps = {.iterations = 1}, .substeps = substeps, .stabilization = soft});
    all[5].push_back({.solver = "wide",
                      .sweeps = {.iterations = 1},
                      .substeps = substeps,
                      .contact_search = when_moved,
                      .stabilization = soft});
  }
  for (const int sweeps : {5, 10, 20, 40, 80, 160, 320}) {
    all[4].push_back({.solver = "wide", .sweeps = {.iterations = sweeps}, .contact_search = when_moved});
    all[6].push_back(
        {.solver = "wide-accelerated", .sweeps = {.iterations = sweeps}, .contact_search = when_moved});
  }
  return all;
}

Contestant cairn_with(const Setting& setting) {
  std::string name = fmt::format("Cairn {} x{}", setting.solver, setting.sweeps.iterations);
  if (setting.sweeps.tolerance > 0)
    name = fmt::format("Cairn {} to {:g}", setting.solver, setting.sweeps.tolerance);
  if (setting.substeps > 1) name += fmt::format(", {} substeps", setting.substeps);
  if (setting.contact_search == when_moved) name += ", moved";
  if (setting.stabilization.policy != Stabilization{}.policy) {
    name += ", " + stabilization_text(setting.stabilization);
  }
  return {name, [setting](const Scene& scene) { return make_cairn(scene, setting); }};
}

using PeerMaker = std::unique_ptr<Engine> (*)(const Scene&, const PeerSettings&);

/// A library that is here or not.
struct Peer {
  std::string name = {};
  std::string version = {};
  PeerMaker make = nullptr;  // none: it was not found
  std::string how_to_have_it = {};
  std::string knob = {};             // what is set, behind its number
  PeerSettings usual = {};           // as it comes
  List<PeerSettings> settings = {};  // of rising cost
};

PeerSettings sweeps(int iterations) { return {.iterations = iterations}; }

List<Peer> all_peers() {
  List<PeerSettings> substeps, iterations, both;
  for (const int count : {2, 4, 8, 16, 32}) substeps.push_back({.substeps = count});
  for (const int count : {5, 10, 20, 40, 80, 160}) iterations.push_back(sweeps(count));
  for (const int count : {4, 8, 16, 32, 64, 128}) {
    both.push_back({.iterations = count, .position_iterations = 3 * count / 8});
  }
  const PeerSettings box2d_2 = {.iterations = 8, .position_iterations = 3};
  List<Peer> peers = {
      {"Box2D 3",
       "",
       nullptr,
       "install it in a folder of its own, and name that in CMAKE_PREFIX_PATH",
       "substeps",
       {.substeps = 4},
       substeps},
      {"Box2D 2.4", "", nullptr, "apt-get install libbox2d-dev", "iterations", box2d_2, both},
      {"Chipmunk", "", nullptr, "apt-get install libchipmunk-dev", "iterations", sweeps(10), iterations},
      {"Bullet", "", nullptr, "apt-get install libbullet-dev", "iterations", sweeps(10), iterations}};
#ifdef CAIRN_PEER_BOX2D_3
  peers[0].make = make_box2d_3,
  peers[0].version = box2d_3_version() + ", with the SIMD that it was built with";
#endif
#ifdef CAIRN_PEER_BOX2D_2
  peers[1].make = make_box2d_2, peers[1].version = CAIRN_BOX2D_2_VERSION;
#endif
#ifdef CAIRN_PEER_CHIPMUNK
  peers[2].make = make_chipmunk, peers[2].version = chipmunk_version();
#endif
#ifdef CAIRN_PEER_BULLET
  peers[3].make = make_bullet, peers[3].version = bullet_version();
#endif
  return peers;
}

Contestant peer_with(const Peer& peer, const PeerSettings& settings) {
  const bool counts_substeps = peer.knob == "substeps";
  std::string number = std::to_string(counts_substeps ? settings.substeps : settings.iterations);
  if (peer.name == "Box2D 2.4") number += fmt::format(" + {}", settings.position_iterations);
  return {fmt::format("{}, {} {}", peer.name, number, peer.knob),
          [make = peer.make, settings](const Scene& scene) { return make(scene, settings); }};
}

}  // namespace

const List<Contestant>& usual_contestants() {
  static const List<Contestant> contestants = [] {
    List<Contestant> all;
    for (const Peer& peer : all_peers()) {
      if (peer.make != nullptr) all.push_back(peer_with(peer, peer.usual));
    }
    all.push_back({"Cairn, the default",
                   [](const Scene& scene) { return make_cairn(scene, default_setting(scene).setting); }});
    for (const Setting& setting : usual_settings_of_cairn()) all.push_back(cairn_with(setting));
    return all;
  }();
  return contestants;
}

const List<Method>& methods() {
  static const List<Method> all_methods = [] {
    List<Method> all;
    for (const Peer& peer : all_peers()) {
      if (peer.make == nullptr) continue;
      Method method;
      for (const PeerSettings& one : peer.settings) method.push_back(peer_with(peer, one));
      all.push_back(method);
    }
    for (const List<Setting>& settings : settings_of_cairn()) {
      Method method;
      for (const Setting& one : settings) method.push_back(cairn_with(one));
      all.push_back(method);
    }
    return all;
  }();
  return all_methods;
}

List<std::string> engine_lines() {
  List<std::string> lines = {fmt::format("{:<9} {}", "Cairn", build_commit())};
  for (const Peer& peer : all_peers()) {
    const std::string missing = "missing: " + peer.how_to_have_it;
    lines.push_back(fmt::format("{:<9} {}", peer.name, peer.make != nullptr ? peer.version : missing));
  }
  return lines;
}

}  // namespace cairn::bench
