// Draws a world from its snapshot.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "render/arrow.hpp"
#include "render/camera.hpp"
#include "render/page.hpp"
#include <cairn/world/snapshot.hpp>

namespace cairn::render {

struct WorldLook {
  bool numbers = true;              // each dynamic body's number in its middle
  PerBody<std::string> names = {};  // instead of numbers; "" for none
  BodyId active_a = {-1};           // lit as a and b
  BodyId active_b = {-1};
  bool contacts = true;     // a dot for each contact point, larger when new
  int active_contact = -1;  // the index of a contact to light
  bool penetration = true;  // marks overlaps of more than 2 px
};

/// Bodies with outline, number and orientation mark; the ground and other immovable bodies hatched at 45
/// degrees; contacts; joints (rod, ring for a pin). Clipped to the camera's viewport.
void draw_world(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look = {});

/// Says which moving bodies the picture does not show: an arrow at the border for those outside, with name
/// and distance from the middle of the view; a ring around those smaller than a pixel; and notes for those
/// whose pose is not finite and for all that there is no room to name. Names are those of `look`, or
/// "body 7".
void draw_unseen(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look = {});

/// Outlines of earlier poses, at most 7 of them evenly chosen, fading with age; the newest is the last.
/// Dynamic bodies only.
void draw_ghosts(Page& page, const Camera& camera, Span<const Snapshot> earlier);

/// The path of a point [m].
void draw_trail(Page& page, const Camera& camera, Span<const Vec2<double>> points, const SeriesStyle& style);

/// Normal and friction force (impulse / dt) [N] of every contact, drawn on body b, labelled with their
/// values.
void draw_contact_forces(Page& page, const Camera& camera, const ArrowScale& scale, const Snapshot& snapshot);

/// Joint forces (impulse / dt) [N] on body b.
void draw_joint_forces(Page& page, const Camera& camera, const ArrowScale& scale, const Snapshot& snapshot);

/// Velocity of every dynamic body at its centre.
void draw_velocities(Page& page, const Camera& camera, const ArrowScale& scale, const Snapshot& snapshot);

/// The box around all dynamic bodies of all snapshots [m]; with the origin, if there are none.
Aabb<double> bounds_of(Span<const Snapshot> snapshots);

}  // namespace cairn::render
