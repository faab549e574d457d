// The tables of the comparison with peers: each prints itself, scene by scene.
#pragma once

#include "peer_scenes.hpp"
#include "runs.hpp"

namespace cairn::bench {

/// Every engine as it comes: time, errors and memory.
void print_equal_work(const List<PeerScene>& scenes, const RunLength& length);
/// The cheapest setting of each engine that keeps errors within the scene's target.
void print_equal_error(const List<PeerScene>& scenes, const RunLength& length);
/// What parts of a step cost, in Cairn and in Box2D 3, which is the only peer that tells.
void print_phases(const List<PeerScene>& scenes, const RunLength& length);
/// As the first, of a pyramid for which all settings would take too long: one of each way.
void print_large_pyramid(const RunLength& usual);
/// What it takes to add a body to many, in Cairn and in Box2D 3.
void print_edits();

/// Whether the adapters agree about a box that falls, one that rests and one that swings; prints what each
/// does. The tables would mean nothing if they did not.
bool adapters_agree();

}  // namespace cairn::bench
